#pragma once
/// \file
/// Runs a campaign, block by block, and reports it like any run.

#include "properties/campaign/state.hpp"

namespace rayproof::campaign {

/// Who hears from a campaign.
struct Watch {
  std::function<void(double done)> progress = [](double) {};
  /// Called after every block; a state that was saved here can be gone on with.
  std::function<void(const CampaignState&)> block = [](const CampaignState&) {};
};

/// Does what is left of the shard's rounds, until the time of the settings is over or `stop` is true; a block
/// that was begun then is not counted. The result is the same for every number of jobs and however often it
/// was stopped.
void run(CampaignState& state, const Watch& watch, const std::atomic<bool>& stop);

/// The state as the result of a run: of each method, precision and broken property the first case in the
/// order of families, shrunk.
[[nodiscard]] RunResult result_of(const CampaignState& state, const Listener& listener,
                                  const std::atomic<bool>& stop);

/// The plan that the result is one of.
[[nodiscard]] Plan plan_of(const CampaignState& state);

}  // namespace rayproof::campaign
