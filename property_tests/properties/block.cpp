#include "properties/block.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

namespace rayproof {

namespace {

std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0;
  for (const char letter : text) hash = combine(hash, static_cast<unsigned char>(letter));
  return hash;
}

/// The cases of a range for a subject that is better asked many at once: theirs, and what the properties ask
/// beside them.
class AskedTogether {
 public:
  AskedTogether(const Unit& unit, std::uint64_t block_seed, unsigned begin, unsigned end) : begin_(begin) {
    for (unsigned k = begin; k != end; ++k) cases_.push_back(case_of(unit, block_seed, k));
    for (unsigned k = begin; k != end; ++k) {
      first_other_.push_back(cases_.size());
      for (std::size_t p = 0; p < unit.active.size(); ++p) {
        const Property& property = properties()[p];
        if (!unit.active[p] || property.asks == nullptr || k % spacing(*unit.subject, property) != 0)
          continue;
        for (Case& other : property.asks(cases_[k - begin])) cases_.push_back(std::move(other));
      }
    }
    first_other_.push_back(cases_.size());
    outcomes_.resize(cases_.size());
    unit.subject->start()->answer(cases_, outcomes_);
  }

  void put_into(BlockResult& result, const Unit& unit) const {
    for (std::size_t i = 0; i + 1 < first_other_.size(); ++i) {
      std::vector<std::pair<const Case*, const Outcome*>> others;
      for (std::size_t j = first_other_[i]; j < first_other_[i + 1]; ++j)
        others.emplace_back(&cases_[j], &outcomes_[j]);
      Trial trial(*unit.subject, cases_[i]);
      trial.know(outcomes_[i], std::move(others));
      result.put(unit, trial, begin_ + static_cast<unsigned>(i));
    }
  }

 private:
  unsigned begin_;
  std::vector<Case> cases_{};
  std::vector<Outcome> outcomes_{};
  std::vector<std::size_t> first_other_{};  ///< for each case of the range, and one more
};

/// A program that fails on so many cases of a family is not asked the others.
constexpr std::uint64_t enough_failures = 8;

}  // namespace

void BlockResult::put(const Unit& unit, Trial& trial, unsigned k) {
  ++tally.cases;
  const std::vector<Property>& all = properties();
  for (std::size_t p = 0; p < all.size(); ++p) {
    if (!unit.active[p] || k % spacing(*unit.subject, all[p]) != 0) continue;
    const Ruling ruling = ruling_of(all[p], trial);
    tally.properties[p].add(ruling);
    if (ruling == Ruling::broken) first_broken.emplace(p, k);
  }
  const bool is_function = unit.subject->function != nullptr;
  if (!is_function) {
    tally.add(trial.outcome());
    if (trial.outcome().is_failure() && !first_failure) first_failure = {k, trial.outcome()};
  }
  if (unit.measure && (is_function || trial.outcome().is_answered())) tally.worst.add(trial);
}

BlockResult& BlockResult::operator+=(const BlockResult& more) {
  tally += more.tally;
  for (const auto& [property, k] : more.first_broken) {
    const auto place = first_broken.emplace(property, k).first;
    place->second = std::min(place->second, k);
  }
  const bool is_later =
      first_failure && more.first_failure && more.first_failure->first < first_failure->first;
  if (is_later || !first_failure) first_failure = more.first_failure;
  return *this;
}

Case case_of(const Unit& unit, std::uint64_t block_seed, unsigned k) {
  return unit.family->generate(combine(block_seed, k), unit.precision);
}

BlockResult run_block(const Unit& unit, std::uint64_t block_seed, unsigned cases,
                      const std::atomic<bool>& stop) {
  using Range = tbb::blocked_range<unsigned>;
  constexpr unsigned cases_at_a_time = 256;
  const bool is_function = unit.subject->function != nullptr;
  std::atomic<std::uint64_t> failures = 0;
  BlockResult none;
  none.tally.properties.resize(properties().size());
  return tbb::parallel_reduce(
      Range(0, cases, cases_at_a_time), none,
      [&](const Range& range, BlockResult result) {
        if (!is_function) {
          if (stop || failures > enough_failures || unit.subject->is_given_up()) return result;
          const std::uint64_t before = result.tally.failures;
          AskedTogether(unit, block_seed, range.begin(), range.end()).put_into(result, unit);
          failures += result.tally.failures - before;
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

std::uint64_t stream_of(const Family& family, Precision precision, std::uint64_t seed) {
  return combine(combine(seed, hash_of(family.topic + "/" + family.name)),
                 precision == Precision::float32 ? 32U : 64U);
}

}  // namespace rayproof
