#include "programs/check/campaign.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "case/files.hpp"
#include "command_line/interrupt.hpp"
#include "command_line/progress_line.hpp"
#include "programs/check/folder_lock.hpp"
#include "programs/check/outputs.hpp"
#include "programs/check/text.hpp"
#include "properties/campaign/run.hpp"
#include "properties/report/findings.hpp"

namespace rayproof::check {

namespace {

/// How long a campaign that is killed loses at most, beside the block that it was in.
constexpr std::chrono::seconds between_saves{2};

/// What is in the folder, or else the campaign that has not begun.
campaign::CampaignState state_of(const Options& options, const campaign::CampaignState& fresh) {
  const std::string file = state_file(options);
  if (!std::filesystem::exists(file)) return fresh;
  if (!options.resume)
    throw std::runtime_error(file +
                             " holds a campaign: --resume goes on with it, --out names another folder");
  campaign::CampaignState begun = campaign::load(file);
  const bool is_same = begun.shard == fresh.shard && campaign::is_alike(begun, fresh);
  if (!is_same)
    throw std::runtime_error(file +
                             " holds another campaign: its seed, cases, filters or shard are not these");
  begun.settings.time = options.settings.time;
  begun.settings.jobs = options.settings.jobs;
  return begun;
}

/// "12 of 40 rounds of shard 2/4".
std::string progress_text(const campaign::CampaignState& state) {
  return fmt::format(
      "{} of {} rounds{}", state.rounds, state.all_rounds(),
      state.shard.count > 1 ? fmt::format(" of shard {}/{}", state.shard.number, state.shard.count) : "");
}

}  // namespace

std::string state_file(const Options& options) {
  return (std::filesystem::path(options.out) / "campaign.json").string();
}

int run_campaign(const Options& options) {
  expect_claimed(make_plan(options.settings));
  const campaign::CampaignState fresh = campaign::begin(options.settings, options.shard);
  make_folder(options.out);
  const FolderLock lock(options.out);
  campaign::CampaignState state = state_of(options, fresh);
  campaign::save(state, state_file(options));  // a folder that cannot be written is known before the work
  keep_on_interrupt();
  ProgressLine progress(state.share_done());
  auto saved = std::chrono::steady_clock::now();
  const auto save = [&](const campaign::CampaignState& now) {
    if (std::chrono::steady_clock::now() - saved < between_saves) return;
    campaign::save(now, state_file(options));
    saved = std::chrono::steady_clock::now();
  };
  const auto show = [&](double done) { progress.show(done, progress_text(state)); };
  campaign::run(state, {show, save}, is_interrupted);
  progress.clear();
  campaign::save(state, state_file(options));
  return report_campaign(state, options);
}

int report_campaign(const campaign::CampaignState& state, const Options& options) {
  Outputs outputs(options);
  Listener listener;
  listener.broken = [&](const Finding& finding) { outputs.keep_as_found(finding); };
  listener.finding = [&](const Finding& finding) { outputs.write(finding); };
  // What was found is shown however the run ended.
  const std::atomic<bool> never{false};
  RunResult result = campaign::result_of(state, listener, never);
  result.was_interrupted |= state.shard.count > 1;  // a part finds less than the whole
  put_in_order(result.findings);
  const Plan plan = campaign::plan_of(state);
  const Summary summary = summarise(plan, result);
  outputs.write(plan, result, summary);
  fmt::print("{}campaign: {}, {}\n", text_outcome(options, plan, result, summary), progress_text(state),
             state_file(options));
  if (is_interrupted) return 130;
  return summary.is_success() ? 0 : 1;
}

}  // namespace rayproof::check
