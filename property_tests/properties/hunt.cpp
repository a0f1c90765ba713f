#include "properties/hunt.hpp"

#include <rapidcheck.h>

#include <exception>
#include <functional>

#include "generators/random.hpp"

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

/// Hears nothing: progress and findings take their own way.
struct Silence : rc::detail::TestListener {
  void onTestCaseFinished(const rc::detail::CaseDescription& /*description*/) override {}
  void onShrinkTried(const rc::detail::CaseDescription& /*shrink*/, bool /*accepted*/) override {}
  void onTestFinished(const rc::detail::TestMetadata& /*metadata*/,
                      const rc::detail::TestResult& /*result*/) override {}
};

bool needs_judgement(const std::vector<bool>& active) {
  for (std::size_t p = 0; p < active.size(); ++p) {
    const Claim claim = properties()[p].claim;
    if (active[p] && (claim == Claim::verdict || claim == Claim::residual || claim == Claim::ulp ||
                      claim == Claim::robust))
      return true;
  }
  return false;
}

/// Runs `test` on so many block seeds, all parameters given here: RC_PARAMS has no say.
rc::detail::TestResult check(const std::string& name, std::uint64_t seed, std::uint64_t blocks,
                             const std::function<void(std::uint64_t)>& test) {
  rc::detail::TestParams params;
  params.seed = seed;
  params.maxSuccess = static_cast<int>(blocks);
  params.maxSize = 100;
  params.disableShrinking = true;
  rc::detail::TestMetadata metadata;
  metadata.id = name;
  metadata.description = name;
  Silence silence;
  return rc::detail::checkTestable([&] { test(*block_seeds()); }, metadata, params, silence,
                                   std::unordered_map<std::string, rc::detail::Reproduce>{});
}

std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0;
  for (const char letter : text) hash = combine(hash, static_cast<unsigned char>(letter));
  return hash;
}

}  // namespace

Tally Hunt::run() {
  Tally tally;
  // Nothing of the subject is in the seed: subjects are put the same cases until one of them breaks.
  const std::uint64_t start = combine(combine(seed, hash_of(family.topic + "/" + family.name)),
                                      precision == Precision::float32 ? 32U : 64U);
  const std::string name = subject.full_name() + " on " + family.name;
  std::uint64_t done = 0;
  std::exception_ptr failure;
  const auto test_block = [&](std::uint64_t block_seed) {
    if (*stop || failure) return;
    const auto size = static_cast<unsigned>(std::min<std::uint64_t>(cases_in_block, cases - done));
    const Block block{
        &subject, &family, precision, block_seed, size, active, measure || needs_judgement(active)};
    BlockResult result;
    try {
      result = rayproof::run(block);
    } catch (...) {  // rapidcheck would take it for a broken property, and the same block would come again
                     // for ever
      failure = std::current_exception();
      return;
    }
    tally += result.tally;
    done += size;
    progress(static_cast<double>(done) / static_cast<double>(cases));
    bool is_new = false;
    for (const auto& [property, k] : result.first_broken) {
      if (!already_broken.insert(property).second) continue;
      found(property, case_of(block, k));
      is_new = true;
    }
    if (is_new) RC_FAIL(name);
  };
  for (std::uint64_t attempt = 0; done < cases && !*stop && !failure; ++attempt)
    check(name, combine(start, attempt), (cases - done + cases_in_block - 1) / cases_in_block, test_block);
  if (failure) std::rethrow_exception(failure);
  return tally;
}

}  // namespace rayproof
