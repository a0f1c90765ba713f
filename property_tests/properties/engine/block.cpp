#include "properties/engine/block.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
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
  AskedTogether(const Unit& unit, std::uint64_t block_seed, unsigned begin, unsigned end, bool asks_others) {
    for (unsigned k = begin; k != end; ++k)
      if (Case one = case_of(unit, block_seed, k); is_for_guest(*unit.subject, one)) {
        cases_.push_back(std::move(one));
        numbers_.push_back(k);
      }
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      first_other_.push_back(cases_.size());
      if (asks_others) append_others(unit, cases_[i], numbers_[i]);
    }
    first_other_.push_back(cases_.size());
    outcomes_.resize(cases_.size());
    unit.subject->start()->answer(cases_, outcomes_);
  }

  /// How much the cases themselves count against asking more.
  [[nodiscard]] unsigned weight() const { return weight_of(std::span(outcomes_).first(numbers_.size())); }
  /// The same of what is asked beside them.
  [[nodiscard]] unsigned weight_of_others() const {
    return weight_of(std::span(outcomes_).subspan(numbers_.size()));
  }

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

namespace {

constexpr unsigned cases_in_range = 256;

/// Four times as many, and whether to go on follows from the last four: the outcome is then the same however
/// many threads there are.
BlockResult run_block_of_program(const Unit& unit, std::uint64_t block_seed, unsigned cases,
                                 const std::atomic<bool>& stop, const BlockResult& none) {
  struct RangeResult {
    BlockResult result;
    unsigned weight = 0, weight_of_others = 0;
  };
  BlockResult result = none;
  constexpr unsigned at_once = 4 * cases_in_range;
  unsigned failures = 0;
  for (unsigned from = 0; from < cases && failures < enough_failures; from += at_once) {
    const bool asks_others = unit.others_failed == nullptr || *unit.others_failed < enough_failures;
    const unsigned end = std::min(cases, from + at_once);
    std::vector<RangeResult> parts((end - from + cases_in_range - 1) / cases_in_range, RangeResult{none});
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
      if (stop || unit.subject->is_given_up()) return;
      const unsigned begin = from + static_cast<unsigned>(i) * cases_in_range;
      const unsigned size = std::min(end - begin, cases_in_range);
      const AskedTogether asked(unit, block_seed, begin, begin + size, asks_others);
      asked.put_into(parts[i].result, unit);
      parts[i].result.tally.left_out += size - parts[i].result.tally.cases;
      parts[i].weight = asked.weight();
      parts[i].weight_of_others = asked.weight_of_others();
    });
    for (const RangeResult& part : parts) {
      result += part.result;
      failures += part.weight;
      if (unit.others_failed != nullptr) *unit.others_failed += part.weight_of_others;
    }
  }
  return result;
}

}  // namespace

BlockResult run_block(const Unit& unit, std::uint64_t block_seed, unsigned cases,
                      const std::atomic<bool>& stop) {
  using Range = tbb::blocked_range<unsigned>;
  BlockResult none;
  none.tally.properties.resize(properties().size());
  none.samples.resize(properties().size());
  if (unit.subject->function == nullptr) return run_block_of_program(unit, block_seed, cases, stop, none);
  const std::span<oracle::JudgedAnswers> judged =
      unit.judged != nullptr ? unit.judged->block(block_seed, cases) : std::span<oracle::JudgedAnswers>();
  return tbb::parallel_reduce(
      Range(0, cases, cases_in_range), none,
      [&](const Range& range, BlockResult result) {
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
