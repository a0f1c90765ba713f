/// \file
/// rayproof check: puts every method on trial before the exact oracle.

#include <csignal>
#include <filesystem>
#include <fstream>

#include "case/shape_format.hpp"
#include "programs/check/corpus.hpp"
#include "programs/check/options.hpp"
#include "programs/check/outputs.hpp"
#include "programs/check/replay.hpp"
#include "programs/command_line.hpp"
#include "programs/progress_line.hpp"
#include "properties/report/text.hpp"

namespace {

using namespace rayproof;

std::atomic<bool> is_interrupted{false};

/// The first Ctrl-C lets the run end with what it has; a second one ends the program as usual.
void interrupt(int signal) {
  is_interrupted = true;
  std::signal(signal, SIG_DFL);
}

std::vector<Case> corpus_of(const check::Options& options) {
  if (options.corpus.empty()) return check::built_in_corpus();
  std::ifstream in(options.corpus);
  if (!in) throw std::runtime_error(options.corpus + " cannot be read");
  return check::read_corpus(in, options.corpus);
}

void print_outcome(const check::Options& options, const Plan& plan, const RunResult& result,
                   const Summary& summary) {
  if (options.labels) fmt::print("{}\n", text_labels(result));
  fmt::print("{}{}", text_families(plan, result), text_table(summary));
  if (options.measure) fmt::print("\n{}", text_measured(summary));
  const auto refuted = std::count_if(result.findings.begin(), result.findings.end(),
                                     [](const Finding& finding) { return finding.is_declared; });
  fmt::print("\n{} corpus cases, {} counterexamples, {} of them as declared\n", result.corpus_cases,
             result.findings.size(), refuted);
  for (const std::string& failure : summary.failures()) fmt::print("FAILED {}\n", failure);
  if (summary.was_interrupted) fmt::print("interrupted: only what is shown was checked\n");
}

int run(const check::Options& options) {
  const Plan plan = make_plan(options.settings);
  const std::vector<Case> corpus = corpus_of(options);
  check::Outputs outputs(options);
  ProgressLine progress;
  fmt::print("seed {}, {} cases for each method, family and precision{}\n", options.settings.seed,
             options.settings.cases, options.settings.time ? " at most" : "");

  Listener listener;
  listener.progress = [&](const Progress& now) { progress.show(now.done, now.what); };
  listener.broken = [&](const Finding& finding) { outputs.keep_as_found(finding); };
  listener.finding = [&](const Finding& finding) {
    progress.clear();
    fmt::print("{}", text_finding(finding));
    std::fflush(stdout);
    outputs.write(finding);
  };
  std::signal(SIGINT, interrupt);
  const RunResult result = run_plan(plan, corpus, listener, is_interrupted);
  progress.clear();

  const Summary summary = summarise(plan, result);
  print_outcome(options, plan, result, summary);
  outputs.write(plan, result, summary);
  fmt::print("page: {}\n{}\n", outputs.page().string(),
             summary.is_success() ? "every contract holds" : "NOT every contract holds");
  if (summary.was_interrupted) return 130;
  return summary.is_success() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Puts every method on trial before the exact oracle, and shrinks what breaks.",
               "rayproof check");
  check::Options options;
  check::describe(app, options);
  if (const auto status = parse_command_line(app, argc, argv)) return *status;
  check::finish(options);
  try {
    return options.replay.empty() ? run(options) : check::replay(options.replay);
  } catch (const UnknownName& unknown) {
    fmt::print(stderr, "rayproof check: {}\n", unknown.what());
  } catch (const std::runtime_error& trouble) {
    fmt::print(stderr, "rayproof check: {}\n", trouble.what());
  }
  return 2;
}
