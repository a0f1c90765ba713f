#include "properties/engine/block.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>

namespace rayproof {

namespace {

std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0;
  for (const char letter : text) hash = combine(hash, static_cast<unsigned char>(letter));
  return hash;
}

/// A program that fails on as many cases of a family is not asked the others: each failure takes long.
constexpr unsigned enough_failures = 4;

/// How much the failures count: silence costs seconds, so that one is enough; a refusal costs nothing.
unsigned weight_of(std::span<const Outcome> outcomes) {
  unsigned weight = 0;
  for (const Outcome& outcome : outcomes)
    if (outcome.is_failure() && outcome.kind != OutcomeKind::refused)
      weight += outcome.kind == OutcomeKind::timed_out ? enough_failures : 1;
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
    for (const std::size_t p : unit.tested) {
      const Property& property = properties()[p];
      if (property.asks == nullptr || k % spacing(*unit.subject, property) != 0) continue;
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

}  // namespace

void BlockResult::put(const Unit& unit, Trial& trial, unsigned k) {
  ++tally.cases;
  const bool is_function = unit.subject->function != nullptr;
  const std::vector<Property>& all = properties();
  for (const std::size_t p : unit.tested) {
    if (k % spacing(*unit.subject, all[p]) != 0) continue;
    const Ruling ruling = ruling_of(all[p], trial);
    tally.properties[p].add(ruling);
    samples[p].add(ruling, k);
    if (ruling == Ruling::broken && first_broken.emplace(p, k).second && !is_function)
      outcomes[p] = trial.outcome();
  }
  if (!is_function) tally.add(trial.outcome());
  if (unit.measure && (is_function || trial.outcome().is_answered())) tally.worst.add(trial);
}

BlockResult& BlockResult::operator+=(const BlockResult& more) {
  tally += more.tally;
  for (std::size_t p = 0; p < samples.size(); ++p) samples[p] += more.samples[p];
  for (const auto& [property, k] : more.first_broken) {
    const auto [place, is_new] = first_broken.emplace(property, k);
    if (!is_new && k >= place->second) continue;
    place->second = k;
    if (const auto outcome = more.outcomes.find(property); outcome != more.outcomes.end())
      outcomes[property] = outcome->second;
  }
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
  const std::span<oracle::JudgedAnswers> judged =
      unit.judged != nullptr ? unit.judged->block(block_seed, cases) : std::span<oracle::JudgedAnswers>();
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
          Trial trial(*unit.subject, one, judged.empty() ? nullptr : &judged[k]);
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
