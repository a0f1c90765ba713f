#pragma once
/// \file
/// A campaign: a run of more cases than one evening has room for, parted among machines and evenings.

#include <map>
#include <string>

#include "properties/engine/engine.hpp"

namespace rayproof::campaign {

/// One of `count` parts of a campaign, counted from 1: every count-th block of each family's cases.
struct Shard {
  std::uint64_t number = 1, count = 1;
  [[nodiscard]] bool operator==(const Shard&) const = default;
};

/// What is known of one method on one family at one precision.
struct UnitState {
  Unit unit{};  ///< its tally is the sum so far
  /// For each broken property (an index into properties()) the number of the first case that broke it.
  std::map<std::size_t, std::uint64_t> first_broken{};

  void add(const UnitState& more);
};

/// All that a campaign has found out. It is written as one JSON object, and sums up in any order to the same.
struct CampaignState {
  Settings settings{};  ///< `cases` is for each method: its families and precisions share them
  Shard shard{};
  std::uint64_t rounds = 0;     ///< done by this shard; a round is a block of each unit
  std::size_t units_ahead = 0;  ///< that have done their block of the next round, too: the first ones
  std::vector<UnitState> units{};

  /// Cases of a unit, and the rounds that this shard has to do.
  [[nodiscard]] std::uint64_t cases_of(const Unit& unit) const;
  [[nodiscard]] std::uint64_t all_rounds() const;
  [[nodiscard]] bool is_whole() const { return rounds == all_rounds(); }
  /// The share that is done, from 0 to 1.
  [[nodiscard]] double share_done() const;
};

/// Whether two are of one campaign: seed, cases, filters and the number of shards are the same.
[[nodiscard]] bool is_alike(const CampaignState& a, const CampaignState& b);

/// As many shards as a campaign may have, and cases of each method.
inline constexpr std::uint64_t most_shards = 1'000'000, most_cases = 1'000'000'000'000;

/// A campaign that has not begun. Throws UnknownName as make_plan does.
[[nodiscard]] CampaignState begin(const Settings& settings, Shard shard);

/// The state as text, and from it. Throws std::runtime_error where the text is no state of a campaign, or of
/// one with methods or families that there are no longer, or where its counts are not those of its rounds.
[[nodiscard]] std::string write_state(const CampaignState& state);
[[nodiscard]] CampaignState read_state(const std::string& text);

/// The same of a file.
void save(const CampaignState& state, const std::string& file);
[[nodiscard]] CampaignState load(const std::string& file);

/// What one run would have come to. Throws std::runtime_error where the shards are not all of one campaign's,
/// each once and to its end.
[[nodiscard]] CampaignState merged(const std::vector<CampaignState>& shards);

}  // namespace rayproof::campaign
