/// \file
/// rayproof check: puts every method on trial before the exact oracle.

#include <filesystem>
#include <fstream>

#include "case/shape_format.hpp"
#include "command_line/command_line.hpp"
#include "command_line/interrupt.hpp"
#include "command_line/progress_line.hpp"
#include "programs/check/corpus.hpp"
#include "programs/check/options.hpp"
#include "programs/check/outcome.hpp"
#include "programs/check/outputs.hpp"
#include "properties/replay.hpp"
#include "properties/report/order.hpp"

namespace {

using namespace rayproof;

std::vector<Case> corpus_of(const check::Options& options) {
  if (options.corpus.empty()) return check::built_in_corpus();
  std::ifstream in(options.corpus);
  if (!in) throw std::runtime_error(options.corpus + " cannot be read");
  return check::read_corpus(in, options.corpus);
}

int run(const check::Options& options) {
  const Plan plan = make_plan(options.settings);
  const std::vector<Case> corpus = corpus_of(options);
  check::Outputs outputs(options);
  keep_on_interrupt();
  ProgressLine progress;
  std::size_t findings = 0;

  Listener listener;
  listener.progress = [&](const Progress& now) {
    progress.show(now.done, fmt::format("{}, {} findings", now.what, findings));
  };
  listener.broken = [&](const Finding& finding) { outputs.keep_as_found(finding); };
  listener.finding = [&](const Finding& finding) {
    ++findings;
    outputs.write(finding);
  };
  RunResult result = run_plan(plan, corpus, listener, is_interrupted);
  put_in_order(result.findings);
  progress.clear();

  const Summary summary = summarise(plan, result);
  outputs.write(plan, result, summary);
  fmt::print("{}", check::text_outcome(options, plan, result, summary));
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
    return options.replay.empty() ? run(options) : replay_file(options.replay);
  } catch (const std::runtime_error& trouble) {
    fmt::print(stderr, "rayproof check: {}\n", trouble.what());
  }
  return 2;
}
