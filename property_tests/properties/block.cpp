#include "properties/block.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "generators/random.hpp"

namespace rayproof {

namespace {

using Range = tbb::blocked_range<unsigned>;
constexpr unsigned cases_at_a_time = 256;

void merge(BlockResult& into, const BlockResult& more) {
  into.tally += more.tally;
  for (const auto& [property, k] : more.first_broken) {
    const auto [place, is_new] = into.first_broken.emplace(property, k);
    if (!is_new) place->second = std::min(place->second, k);
  }
}

void count(Ruling ruling, PropertyTally& tally) {
  switch (ruling) {
    case Ruling::held:
      ++tally.held;
      break;
    case Ruling::broken:
      ++tally.broken;
      break;
    case Ruling::outside:
      ++tally.outside;
      break;
  }
}

void run_case(const Block& block, unsigned k, BlockResult& result) {
  const Case one = case_of(block, k);
  Trial trial(*block.subject, one);
  ++result.tally.cases;
  if (block.measure) result.tally.worst.add(trial);
  const std::vector<Property>& all = properties();
  for (std::size_t p = 0; p < all.size(); ++p) {
    if (!block.active[p] || k % all[p].every != 0) continue;
    const Ruling ruling = all[p].rule(trial);
    count(ruling, result.tally.properties[p]);
    if (ruling == Ruling::broken) result.first_broken.emplace(p, k);
  }
}

}  // namespace

Case case_of(const Block& block, unsigned k) {
  return block.family->generate(combine(block.seed, k), block.precision);
}

BlockResult run(const Block& block) {
  BlockResult none;
  none.tally.properties.resize(properties().size());
  return tbb::parallel_reduce(
      Range(0, block.cases, cases_at_a_time), none,
      [&](const Range& range, BlockResult result) {
        for (unsigned k = range.begin(); k != range.end(); ++k) run_case(block, k, result);
        return result;
      },
      [](BlockResult left, const BlockResult& right) {
        merge(left, right);
        return left;
      });
}

}  // namespace rayproof
