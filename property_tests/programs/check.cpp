/// \file
/// rayproof check: puts every method on trial before the exact oracle.

#include "case/files.hpp"
#include "command_line/command_line.hpp"
#include "command_line/interrupt.hpp"
#include "command_line/progress_line.hpp"
#include "programs/check/campaign.hpp"
#include "programs/check/corpus.hpp"
#include "programs/check/folder_lock.hpp"
#include "programs/check/guests.hpp"
#include "programs/check/leaving.hpp"
#include "programs/check/options.hpp"
#include "programs/check/outputs.hpp"
#include "programs/check/text.hpp"
#include "properties/replay.hpp"
#include "properties/report/findings.hpp"
#include "properties/report/guest.hpp"

namespace {

using namespace rayproof;

int run(const check::Options& options) {
  ProgressLine progress;
  keep_on_interrupt();
  std::vector<Subject> guests;
  std::vector<Failure> failures;
  if (options.has_guests()) {
    guests = check::subjects_of(options);
    failures = check::learn_all(guests, options.settings, [&](double done) {
      progress.show(done, "what the program's answers hold is found out");
    });
  }
  Plan plan = guests.empty() ? make_plan(options.settings) : make_plan(options.settings, guests);
  if (guests.empty()) expect_claimed(plan);
  plan.failures = std::move(failures);
  const std::vector<Case> corpus = check::read_corpus(options.corpus);
  make_folder(options.out);
  const check::FolderLock lock(options.out);
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
  const bool is_kept = !left || check::report_leaving(options, *left);
  fmt::print("{}", guests.empty() ? check::text_outcome(options, plan, result, summary)
                                  : check::text_of_guests(options, plan, result));
  std::fflush(stdout);  // what was found is shown even where the disk has no room for the page
  outputs.write(plan, result, summary);
  if (summary.was_interrupted || is_interrupted) return 130;
  if (!guests.empty()) return verdict_on_guests(plan, result).is_clean ? 0 : 1;
  return summary.is_success() && is_kept ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine app("Puts every method on trial before the exact oracle, and shrinks what breaks.",
                  "rayproof check");
  check::Options options;
  check::describe(app, options);
  if (const auto status = parse_command_line(app, argc, argv)) return *status;
  options.settings.cases =
      options.cases.value_or(options.has_guests() ? check::usual_cases_of_command : check::usual_cases);
  options.settings.count_labels = !options.has_guests();
  try {
    check::refuse_idle_options(app, options);
    if (options.campaign) return check::run_campaign(options);
    return options.replay.empty() ? run(options) : replay_file(options.replay);
  } catch (const std::exception& trouble) {
    print_trouble("rayproof check", trouble);
  }
  return 2;
}
