#include "properties/campaign/state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "properties/engine/units.hpp"

namespace rayproof::campaign {

namespace {

std::string name_of(const Shard& shard) { return fmt::format("shard {}/{}", shard.number, shard.count); }

}  // namespace

bool is_alike(const CampaignState& a, const CampaignState& b) {
  const Settings &one = a.settings, &other = b.settings;
  return one.seed == other.seed && one.cases == other.cases && one.shapes == other.shapes &&
         one.methods == other.methods && one.properties == other.properties &&
         one.families == other.families && one.precisions == other.precisions &&
         a.shard.count == b.shard.count && a.units.size() == b.units.size();
}

void UnitState::add(const UnitState& more) {
  unit.tally += more.unit.tally;
  for (const auto& [property, number] : more.first_broken) {
    const auto place = first_broken.emplace(property, number).first;
    place->second = std::min(place->second, number);
  }
}

std::uint64_t CampaignState::cases_of(const Unit& unit) const {
  const auto shares = static_cast<std::uint64_t>(
      std::ranges::count_if(units, [&](const UnitState& one) { return one.unit.subject == unit.subject; }));
  return (settings.cases + shares - 1) / shares;
}

std::uint64_t CampaignState::all_rounds() const {
  std::uint64_t most = 0;
  for (const UnitState& one : units) most = std::max(most, cases_of(one.unit));
  const std::uint64_t blocks = (most + cases_in_block - 1) / cases_in_block;
  return (blocks + shard.count - shard.number) / shard.count;
}

double CampaignState::share_done() const {
  if (is_whole()) return 1;
  const auto of_round = static_cast<double>(units_ahead) / static_cast<double>(units.size());
  return (static_cast<double>(rounds) + of_round) / static_cast<double>(all_rounds());
}

CampaignState begin(const Settings& settings, Shard shard) {
  CampaignState state{.settings = settings, .shard = shard};
  for (Unit& unit : units_of(make_plan(settings))) {
    unit.tally.properties.resize(properties().size());
    state.units.push_back({std::move(unit)});
  }
  return state;
}

CampaignState merged(const std::vector<CampaignState>& shards) {
  if (shards.empty()) throw std::runtime_error("there is nothing to merge");
  CampaignState whole = begin(shards.front().settings, {});
  std::vector<bool> is_there(shards.front().shard.count, false);
  for (const CampaignState& one : shards) {
    if (!is_alike(one, shards.front()))
      throw std::runtime_error(
          "the shards are not of one campaign: seed, cases, filters or their number differ");
    if (!one.is_whole())
      throw std::runtime_error(
          fmt::format("{} is not finished: {} of {} rounds are done; go on with --resume", name_of(one.shard),
                      one.rounds, one.all_rounds()));
    if (is_there.at(one.shard.number - 1))
      throw std::runtime_error(fmt::format("{} is given twice", name_of(one.shard)));
    is_there.at(one.shard.number - 1) = true;
    for (std::size_t i = 0; i < whole.units.size(); ++i) whole.units[i].add(one.units[i]);
  }
  if (const auto missing = std::ranges::find(is_there, false); missing != is_there.end())
    throw std::runtime_error(
        fmt::format("shard {}/{} is missing", missing - is_there.begin() + 1, is_there.size()));
  whole.rounds = whole.all_rounds();
  return whole;
}

}  // namespace rayproof::campaign
