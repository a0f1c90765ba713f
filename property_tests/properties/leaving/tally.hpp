#pragma once
/// \file
/// What is counted of the rays that a strategy starts. Tallies add up in any order to the same sum.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace rayproof::leaving {

/// How many lengths fall into each quarter of a power of two, relative to the size of their scene.
class Lengths {
 public:
  void add(double length) {
    const double place = length > 0 ? 4 * (std::log2(length) - lowest) : 0;
    const double last = static_cast<double>(counts_.size() - 1);
    ++counts_.at(static_cast<std::size_t>(std::clamp(place, 0.0, last)));
    ++all_;
    largest_ = std::max(largest_, length);
  }
  Lengths& operator+=(const Lengths& more) {
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_.at(i) += more.counts_.at(i);
    all_ += more.all_;
    largest_ = std::max(largest_, more.largest_);
    return *this;
  }

  /// The length that `share` of all do not exceed, to an eighth of a power of two; 0 where these are smaller
  /// than any that is counted apart.
  [[nodiscard]] double quantile(double share) const {
    std::uint64_t below = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      below += counts_.at(i);
      if (static_cast<double>(below) >= share * static_cast<double>(all_))
        return i == 0 ? 0 : std::min(largest_, std::exp2(lowest + (static_cast<double>(i) + 0.5) / 4));
    }
    return 0;
  }
  [[nodiscard]] double median() const { return quantile(0.5); }
  [[nodiscard]] double largest() const { return largest_; }

 private:
  static constexpr double lowest = -70;
  std::array<std::uint32_t, 360> counts_{};
  std::uint64_t all_ = 0;
  double largest_ = 0;
};

/// Of one strategy, in scenes of about one size.
struct Count {
  std::uint64_t rays = 0;
  std::uint64_t false_hits = 0;  ///< and rays without an origin
  std::uint64_t skipped = 0;
  std::uint64_t misanswered = 0;  ///< clear by the exact answer, and the shape's plain method reports a hit
  Lengths offsets{};              ///< from where the strategy starts, relative to the size of the scene
  double thickest_skipped = 0;    ///< of the solids that were skipped, relative to the same
  /// Rays that are clear and were compared with the proven strategy's, and those of which its offset is at
  /// least ten times smaller.
  std::uint64_t compared = 0, tenfold = 0;

  Count& operator+=(const Count& more) {
    rays += more.rays;
    false_hits += more.false_hits;
    skipped += more.skipped;
    misanswered += more.misanswered;
    offsets += more.offsets;
    thickest_skipped = std::max(thickest_skipped, more.thickest_skipped);
    compared += more.compared;
    tenfold += more.tenfold;
    return *this;
  }
};

/// Scenes by their size: the power of ten below it.
inline constexpr int least_decade = -7, decades = 16;
[[nodiscard]] inline std::size_t decade_of(double size) {
  const double place = size > 0 ? std::floor(std::log10(size)) - least_decade : 0;
  return static_cast<std::size_t>(std::clamp(place, 0.0, decades - 1.0));
}

/// Of one strategy: by the size of the scene, and the first situation in which it failed.
struct StrategyTally {
  std::array<Count, decades> by_size{};
  std::optional<std::uint64_t> first_failure{};  ///< the number of the situation

  void fail(std::uint64_t number) { first_failure = std::min(first_failure.value_or(number), number); }
  StrategyTally& operator+=(const StrategyTally& more) {
    for (std::size_t i = 0; i < by_size.size(); ++i) by_size.at(i) += more.by_size.at(i);
    if (more.first_failure) fail(*more.first_failure);
    return *this;
  }
  [[nodiscard]] Count all() const {
    Count sum;
    for (const Count& one : by_size) sum += one;
    return sum;
  }
};

}  // namespace rayproof::leaving
