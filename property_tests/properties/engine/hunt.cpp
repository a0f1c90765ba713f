#include "properties/engine/hunt.hpp"

#include <rapidcheck.h>
#include <rapidcheck/detail/TestListenerAdapter.h>

#include <algorithm>
#include <exception>

#include "properties/engine/block.hpp"

namespace rayproof {

namespace {

/// Draws the seed of a block. It has no shrinks: the failing case itself goes to our own shrinker, which
/// knows what is simple.
rc::Gen<std::uint64_t> block_seeds() {
  return {[](const rc::Random& random, int /*size*/) {
    rc::Random own = random;
    return rc::shrinkable::just(static_cast<std::uint64_t>(own.next()));
  }};
}

/// Runs `test` on block seeds, all parameters given here: RC_PARAMS has no say. rapidcheck reports to nobody,
/// since progress and findings are reported elsewhere.
void check(std::uint64_t seed, std::uint64_t blocks, const std::function<void(std::uint64_t)>& test) {
  rc::detail::TestParams params;
  params.seed = seed;
  params.maxSuccess = static_cast<int>(blocks);
  params.maxSize = 100;
  params.disableShrinking = true;
  rc::detail::TestListenerAdapter silence;
  rc::detail::checkTestable([&] { test(*block_seeds()); }, rc::detail::TestMetadata{}, params, silence,
                            std::unordered_map<std::string, rc::detail::Reproduce>{});
}

}  // namespace

std::uint64_t seed_of_first_block(const Family& family, Precision precision, std::uint64_t seed) {
  std::uint64_t found = 0;
  check(combine(stream_of(family, precision, seed), 0), 1,
        [&](std::uint64_t block_seed) { found = block_seed; });
  return found;
}

std::vector<std::uint64_t> seeds_of_blocks(const Family& family, Precision precision,
                                           std::uint64_t seed_of_run, std::uint64_t blocks) {
  std::vector<std::uint64_t> seeds;
  check(combine(stream_of(family, precision, combine(seed_of_run, 0)), 0), blocks,
        [&](std::uint64_t block_seed) { seeds.push_back(block_seed); });
  return seeds;
}

void Hunt::run() {
  const std::uint64_t start = stream_of(*unit.family, unit.precision, seed);
  std::uint64_t done = 0;
  std::exception_ptr failure;
  const auto test_block = [&](std::uint64_t block_seed) {
    if (stop || failure) return;
    const auto size = static_cast<unsigned>(std::min<std::uint64_t>(cases_in_block, cases - done));
    BlockResult result;
    try {
      result = run_block(unit, block_seed, size, stop);
    } catch (...) {  // rapidcheck would take it for a broken property, and repeat the same block endlessly
      failure = std::current_exception();
      return;
    }
    unit.tally += result.tally;
    done += size;
    progress(static_cast<double>(done) / static_cast<double>(cases));
    for (std::size_t p = 0; p < result.samples.size(); ++p) sampled(p, block_seed, result.samples[p]);
    bool is_new = false;
    for (const auto& [property, k] : result.first_broken) {
      if (!already_broken.insert(property).second) continue;
      const auto outcome = result.outcomes.find(property);
      found(property, case_of(unit, block_seed, k),
            outcome == result.outcomes.end() ? nullptr : &outcome->second);
      is_new = true;
    }
    if (is_new) RC_FAIL("a property is broken for the first time");
  };
  for (std::uint64_t attempt = 0; done < cases && !stop && !failure; ++attempt)
    check(combine(start, attempt), (cases - done + cases_in_block - 1) / cases_in_block, test_block);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace rayproof
