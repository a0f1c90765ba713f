#pragma once
/// \file
/// rayproof check --campaign, and what rayproof merge makes of its shards.

#include "programs/check/options.hpp"

namespace rayproof::check {

/// Runs a campaign, or what is left of it; the exit status.
[[nodiscard]] int run_campaign(const Options& options);

/// Writes what came of a campaign, as `check` does, and prints it; the exit status.
[[nodiscard]] int report_campaign(const campaign::CampaignState& state, const Options& options);

/// The file of the state in the folder of the outputs.
[[nodiscard]] std::string state_file(const Options& options);

}  // namespace rayproof::check
