#include "properties/hunt.hpp"

#include <rapidcheck.h>
#include <rapidcheck/detail/TestListenerAdapter.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <exception>
#include <map>

namespace rayproof {

namespace {

/// What came of a block of cases. Its k-th case is the one that combine(seed of the block, k) stands for.
struct BlockResult {
  Tally tally{};
  std::vector<BlockSample> samples{};  ///< in the order of properties()
  /// For each broken property (an index into properties()) the first case that broke it, by number.
  std::map<std::size_t, unsigned> first_broken{};
  /// What came of asking the first case without an answer that should have got one, and its number.
  std::optional<std::pair<unsigned, Outcome>> first_failure{};

  void put(const Unit& unit, Trial& trial, unsigned k) {
    ++tally.cases;
    const std::vector<Property>& all = properties();
    for (std::size_t p = 0; p < all.size(); ++p) {
      if (!unit.active[p] || k % spacing(*unit.subject, all[p]) != 0) continue;
      const Ruling ruling = ruling_of(all[p], trial);
      tally.properties[p].add(ruling);
      samples[p].add(ruling, k);
      if (ruling == Ruling::broken) first_broken.emplace(p, k);
    }
    const bool is_function = unit.subject->function != nullptr;
    if (!is_function) {
      tally.add(trial.outcome());
      if (trial.outcome().is_failure() && !first_failure) first_failure = {k, trial.outcome()};
    }
    if (unit.measure && (is_function || trial.outcome().is_answered())) tally.worst.add(trial);
  }

  BlockResult& operator+=(const BlockResult& more) {
    tally += more.tally;
    for (std::size_t p = 0; p < samples.size(); ++p) samples[p] += more.samples[p];
    for (const auto& [property, k] : more.first_broken) {
      const auto place = first_broken.emplace(property, k).first;
      place->second = std::min(place->second, k);
    }
    const bool is_later =
        first_failure && more.first_failure && more.first_failure->first < first_failure->first;
    if (is_later || !first_failure) first_failure = more.first_failure;
    return *this;
  }
};

Case case_of(const Unit& unit, std::uint64_t block_seed, unsigned k) {
  return unit.family->generate(combine(block_seed, k), unit.precision);
}

/// A program that fails on as many cases of a family is not asked the others: each failure takes long.
constexpr unsigned enough_failures = 4;

/// How much the failures count: silence costs seconds, so that one is enough; a refusal costs nothing.
unsigned weight_of(std::span<const Outcome> outcomes) {
  unsigned weight = 0;
  for (const Outcome& outcome : outcomes)
    if (outcome.is_failure() && outcome.kind != Outcome::Kind::refused)
      weight += outcome.kind == Outcome::Kind::timed_out ? enough_failures : 1;
  return weight;
}

/// The cases of a range that are for a guest, and what the properties ask beside them, asked all at once.
class AskedTogether {
 public:
  AskedTogether(const Unit& unit, std::uint64_t block_seed, unsigned begin, unsigned end) {
    for (unsigned k = begin; k != end; ++k)
      if (Case one = case_of(unit, block_seed, k); is_for_guest(*unit.subject, one)) {
        cases_.push_back(std::move(one));
        numbers_.push_back(k);
      }
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      first_other_.push_back(cases_.size());
      append_others(unit, cases_[i], numbers_[i]);
    }
    first_other_.push_back(cases_.size());
    outcomes_.resize(cases_.size());
    unit.subject->start()->answer(cases_, outcomes_);
    if (unit.others_failed != nullptr)
      *unit.others_failed += weight_of(std::span(outcomes_).subspan(numbers_.size()));
  }

  /// How much the cases themselves count against asking more.
  [[nodiscard]] unsigned weight() const { return weight_of(std::span(outcomes_).first(numbers_.size())); }

  void put_into(BlockResult& result, const Unit& unit) const {
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      std::vector<std::pair<const Case*, const Outcome*>> others;
      for (std::size_t j = first_other_[i]; j < first_other_[i + 1]; ++j)
        others.emplace_back(&cases_[j], &outcomes_[j]);
      Trial trial(*unit.subject, cases_[i]);
      trial.know(outcomes_[i], std::move(others));
      result.put(unit, trial, numbers_[i]);
    }
  }

 private:
  void append_others(const Unit& unit, const Case& one, unsigned k) {
    if (unit.others_failed != nullptr && *unit.others_failed >= enough_failures) return;
    std::vector<Case> others;
    for (std::size_t p = 0; p < unit.active.size(); ++p) {
      const Property& property = properties()[p];
      if (!unit.active[p] || property.asks == nullptr || k % spacing(*unit.subject, property) != 0) continue;
      for (Case& other : property.asks(one)) others.push_back(std::move(other));
    }
    for (Case& other : others)
      if (is_for_guest(*unit.subject, other)) cases_.push_back(std::move(other));
  }

  std::vector<Case> cases_{};
  std::vector<unsigned> numbers_{};  ///< of the cases in their block
  std::vector<Outcome> outcomes_{};
  std::vector<std::size_t> first_other_{};  ///< for each of the numbers, and one more
};

BlockResult run_block(const Unit& unit, std::uint64_t block_seed, unsigned cases,
                      const std::atomic<bool>& stop) {
  using Range = tbb::blocked_range<unsigned>;
  constexpr unsigned cases_at_a_time = 256;
  const bool is_function = unit.subject->function != nullptr;
  std::atomic<unsigned> failures = 0;
  BlockResult none;
  none.tally.properties.resize(properties().size());
  none.samples.resize(properties().size());
  return tbb::parallel_reduce(
      Range(0, cases, cases_at_a_time), none,
      [&](const Range& range, BlockResult result) {
        if (!is_function) {
          if (stop || failures >= enough_failures || unit.subject->is_given_up()) return result;
          const std::uint64_t before = result.tally.cases;
          const AskedTogether asked(unit, block_seed, range.begin(), range.end());
          asked.put_into(result, unit);
          result.tally.left_out += range.size() - (result.tally.cases - before);
          failures += asked.weight();
          return result;
        }
        for (unsigned k = range.begin(); k != range.end(); ++k) {
          const Case one = case_of(unit, block_seed, k);
          Trial trial(*unit.subject, one);
          result.put(unit, trial, k);
        }
        return result;
      },
      [](BlockResult left, const BlockResult& right) { return left += right; });
}

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

std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0;
  for (const char letter : text) hash = combine(hash, static_cast<unsigned char>(letter));
  return hash;
}

/// Nothing of the subject is in the seed: subjects are put the same cases until one of them breaks.
std::uint64_t start_of(const Family& family, Precision precision, std::uint64_t seed) {
  return combine(combine(seed, hash_of(family.topic + "/" + family.name)),
                 precision == Precision::float32 ? 32U : 64U);
}

}  // namespace

std::uint64_t seed_of_first_block(const Family& family, Precision precision, std::uint64_t seed) {
  std::uint64_t found = 0;
  check(combine(start_of(family, precision, seed), 0), 1,
        [&](std::uint64_t block_seed) { found = block_seed; });
  return found;
}

std::vector<std::uint64_t> seeds_of_blocks(const Family& family, Precision precision,
                                           std::uint64_t seed_of_run, std::uint64_t blocks) {
  std::vector<std::uint64_t> seeds;
  check(combine(start_of(family, precision, combine(seed_of_run, 0)), 0), blocks,
        [&](std::uint64_t block_seed) { seeds.push_back(block_seed); });
  return seeds;
}

void Hunt::run() {
  const std::uint64_t start = start_of(*unit.family, unit.precision, seed);
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
      const bool is_failure = properties()[property].claim == Claim::answers && result.first_failure;
      found(property, case_of(unit, block_seed, k), is_failure ? &result.first_failure->second : nullptr);
      is_new = true;
    }
    if (is_new) RC_FAIL("a property is broken for the first time");
  };
  for (std::uint64_t attempt = 0; done < cases && !stop && !failure; ++attempt)
    check(combine(start, attempt), (cases - done + cases_in_block - 1) / cases_in_block, test_block);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace rayproof
