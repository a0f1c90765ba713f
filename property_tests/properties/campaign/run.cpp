#include "properties/campaign/run.hpp"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <set>

#include "generators/random.hpp"
#include "properties/engine/block.hpp"
#include "properties/engine/found.hpp"

namespace rayproof::campaign {

namespace {

/// The seed of a block is a function of its number: every shard can make its own.
std::uint64_t seed_of(const CampaignState& state, const Unit& unit, std::uint64_t block) {
  return combine(stream_of(*unit.family, unit.precision, state.settings.seed), block);
}

/// One block of a unit, or nothing where it has no more cases there.
UnitState block_of(const CampaignState& state, const UnitState& one, std::uint64_t block,
                   const std::atomic<bool>& stop) {
  const std::uint64_t all = state.cases_of(one.unit), begin = block * cases_in_block;
  UnitState more;
  more.unit.tally.properties.resize(properties().size());
  if (begin >= all) return more;
  const auto count = static_cast<unsigned>(std::min<std::uint64_t>(cases_in_block, all - begin));
  const BlockResult result = run_block(one.unit, seed_of(state, one.unit, block), count, stop);
  more.unit.tally = result.tally;
  for (const auto& [property, k] : result.first_broken) more.first_broken[property] = begin + k;
  return more;
}

/// The block of the next unit; nothing of it counts where it was stopped within.
void run_next(CampaignState& state, const std::atomic<bool>& stop) {
  const std::uint64_t block = state.rounds * state.shard.count + state.shard.number - 1;
  UnitState& one = state.units[state.units_ahead];
  const UnitState more = block_of(state, one, block, stop);
  if (stop) return;
  one.add(more);
  if (++state.units_ahead < state.units.size()) return;
  state.units_ahead = 0;
  ++state.rounds;
}

}  // namespace

void run(CampaignState& state, const Watch& watch, const std::atomic<bool>& stop) {
  const int jobs = state.settings.jobs > 0 ? state.settings.jobs : tbb::this_task_arena::max_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(jobs));
  tbb::task_arena arena(jobs);
  const auto start = std::chrono::steady_clock::now();
  arena.execute([&] {
    const std::uint64_t all = state.all_rounds();
    while (state.rounds < all && !stop) {
      run_next(state, stop);
      watch.progress(state.share_done());
      watch.block(state);
      if (state.settings.time && std::chrono::steady_clock::now() - start > *state.settings.time) return;
    }
  });
}

Plan plan_of(const CampaignState& state) {
  Plan plan = make_plan(state.settings);
  if (!state.units.empty()) plan.settings.cases = state.cases_of(state.units.front().unit);
  return plan;
}

RunResult result_of(const CampaignState& state, const Listener& listener, const std::atomic<bool>& stop) {
  RunResult result;
  std::set<std::tuple<const Subject*, Precision, std::size_t>> is_shown;
  for (const UnitState& one : state.units) {
    result.units.push_back(one.unit);
    for (const auto& [property, number] : one.first_broken) {
      if (!is_shown.insert({one.unit.subject, one.unit.precision, property}).second) continue;
      const std::uint64_t block = number / cases_in_block;
      const Case broken =
          case_of(one.unit, seed_of(state, one.unit, block), static_cast<unsigned>(number % cases_in_block));
      if (auto finding = made_of({*one.unit.subject, properties()[property], broken, one.unit.family->name},
                                 listener, stop))
        result.findings.push_back(std::move(*finding));
    }
  }
  result.was_interrupted = !state.is_whole();
  return result;
}

}  // namespace rayproof::campaign
