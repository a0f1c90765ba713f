/// \file
/// rayproof check: puts every method on trial before the exact oracle.

#include "command_line/command_line.hpp"
#include "command_line/interrupt.hpp"
#include "command_line/progress_line.hpp"
#include "programs/check/corpus.hpp"
#include "programs/check/guests.hpp"
#include "programs/check/leaving.hpp"
#include "programs/check/options.hpp"
#include "programs/check/outputs.hpp"
#include "properties/replay.hpp"
#include "properties/report/findings.hpp"
#include "properties/report/guest.hpp"
#include "properties/report/report.hpp"

namespace {

using namespace rayproof;

/// What breaks a contract, in full: first what has a counterexample.
std::string all_failures(const RunResult& result, const Summary& summary) {
  if (summary.is_success()) return "";
  std::string text = "\nFAILED\n" + text_failures(result.findings);
  for (const std::string& sentence : summary.without_counterexample()) text += sentence + "\n";
  return text;
}

/// What is printed at the end: the table, the failures in full, the findings, and what may be done with them;
/// at most 120 columns wide but for the cases of failures.
std::string text_outcome(const check::Options& options, const Plan& plan, const RunResult& result,
                         const Summary& summary) {
  std::string text = fmt::format(
      "seed {}, {}{} cases for each method, family and precision, {} corpus cases\n", plan.settings.seed,
      plan.settings.time ? "at most " : "", plan.settings.cases, result.corpus_cases);
  if (options.labels) text += text_labels(result) + "\n";
  if (plan.settings.measure_all) text += text_families(plan, result) + text_measured(summary) + "\n";
  text += text_table(summary) + all_failures(result, summary);
  if (const std::string declared = text_declared(result.findings); !declared.empty())
    text +=
        "\nFindings that the contracts declare (several numbers: the same failure in the other precision or "
        "method)\n" +
        declared;
  if (!result.findings.empty())
    text += fmt::format("\n./rayproof explain N, walk N, draw N, replay N{}: look into finding N\n",
                        from_option(options.out));
  text += fmt::format("how to read it: docs/reading-a-check.md\npage: {}/index.html\n", options.out);
  if (summary.was_interrupted) text += "interrupted: only what is shown was checked\n";
  return text + (!summary.is_success() ? "NOT every contract holds\n"
                 : summary.was_interrupted
                     ? "no contract is broken by what was checked before the interrupt\n"
                     : "every contract holds\n");
}

/// The same of programs: the findings in full, and what was judged of each shape.
std::string text_of_guests(const check::Options& options, const Plan& plan, const RunResult& result) {
  std::string text =
      fmt::format("{}\nseed {}, {}{} cases for each shape, family and precision\n", options.command,
                  plan.settings.seed, plan.settings.time ? "at most " : "", plan.settings.cases);
  if (!result.findings.empty()) text += "\nFINDINGS\n" + text_failures(result.findings) + "\n";
  text += text_guests(plan, result);
  if (!result.findings.empty())
    text += fmt::format("./rayproof explain N, draw N, replay N{}: look into finding N\n",
                        from_option(options.out));
  text += fmt::format("page: {}/index.html\n", options.out);
  if (result.was_interrupted) text += "interrupted: only what is shown was checked\n";
  return text + verdict_on_guests(plan, result).sentence + "\n";
}

int run(const check::Options& options) {
  ProgressLine progress;
  keep_on_interrupt();
  std::vector<Subject> guests;
  std::vector<Failure> failures;
  if (!options.command.empty()) {
    guests = check::subjects_of(options);
    failures = check::learn_all(guests, options.settings, [&](double done) {
      progress.show(done, "what the program's answers hold is found out");
    });
  }
  Plan plan = guests.empty() ? make_plan(options.settings) : make_plan(options.settings, guests);
  plan.failures = std::move(failures);
  const std::vector<Case> corpus = check::read_corpus(options.corpus);
  check::Outputs outputs(options);
  std::size_t findings = 0;

  Listener listener;
  listener.progress = [&](const std::string& what, double done) {
    progress.show(done, fmt::format("{}, {} findings", what, findings));
  };
  listener.broken = [&](const Finding& finding) { outputs.keep_as_found(finding); };
  listener.finding = [&](const Finding& finding) {
    ++findings;
    outputs.write(finding);
  };
  RunResult result = run_plan(plan, corpus, listener, is_interrupted);
  put_in_order(result.findings);
  const std::optional<leaving::SearchResult> left =
      guests.empty() ? check::leave_surfaces(options.settings, listener.progress) : std::nullopt;
  progress.clear();

  const Summary summary = summarise(plan, result);
  outputs.write(plan, result, summary);
  const bool is_kept = !left || check::report_leaving(options, *left);
  fmt::print("{}", guests.empty() ? text_outcome(options, plan, result, summary)
                                  : text_of_guests(options, plan, result));
  if (summary.was_interrupted || is_interrupted) return 130;
  if (!guests.empty()) return verdict_on_guests(plan, result).is_clean ? 0 : 1;
  return summary.is_success() && is_kept ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Puts every method on trial before the exact oracle, and shrinks what breaks.",
               "rayproof check");
  check::Options options;
  check::describe(app, options);
  if (const auto status = parse_command_line(app, argc, argv)) return *status;
  options.settings.cases =
      options.cases.value_or(options.command.empty() ? check::usual_cases : check::usual_cases_of_command);
  options.settings.count_labels = options.command.empty();
  try {
    return options.replay.empty() ? run(options) : replay_file(options.replay);
  } catch (const std::runtime_error& trouble) {
    fmt::print(stderr, "rayproof check: {}\n", trouble.what());
  }
  return 2;
}
