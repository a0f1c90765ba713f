#pragma once
/// \file
/// Samples of the cases on which a subject breaks a property, and of those on which it keeps it: what a
/// diagnosis looks at.

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

#include "generators/generators.hpp"
#include "properties/property.hpp"

namespace rayproof {

/// The numbers of the first cases of a block that broke a property, and of the first that kept it.
struct BlockSample {
  static constexpr std::size_t most_broken = 16, most_held = 6;
  std::vector<unsigned> broken{};
  std::vector<unsigned> held{};

  /// Takes in a case; within a block, cases come in ascending order.
  void add(Ruling ruling, unsigned k) {
    if (ruling == Ruling::broken && broken.size() < most_broken) broken.push_back(k);
    if (ruling == Ruling::held && held.size() < most_held) held.push_back(k);
  }
  BlockSample& operator+=(const BlockSample& more) {
    merge(broken, more.broken, most_broken);
    merge(held, more.held, most_held);
    return *this;
  }

 private:
  static void merge(std::vector<unsigned>& into, const std::vector<unsigned>& more, std::size_t most) {
    into.insert(into.end(), more.begin(), more.end());
    std::ranges::sort(into);
    if (into.size() > most) into.resize(most);
  }
};

/// A case that a family makes from a seed.
struct SeededCase {
  const Family* family = nullptr;
  Precision precision{};
  std::uint64_t seed = 0;

  [[nodiscard]] Case generate() const { return family->generate(seed, precision); }
};

/// The samples of a whole run, by subject, precision and property.
class Samples {
 public:
  struct PropertySample {
    std::vector<SeededCase> broken{};
    std::vector<SeededCase> held{};
  };

  void add(const Subject& subject, const Family& family, Precision precision, const Property& property,
           std::uint64_t block_seed, const BlockSample& block) {
    PropertySample& sample = all_[{&subject, precision, &property}];
    const auto append = [&](std::vector<SeededCase>& to, const std::vector<unsigned>& numbers,
                            std::size_t most) {
      for (const unsigned k : numbers)
        if (to.size() < most) to.push_back({&family, precision, combine(block_seed, k)});
    };
    append(sample.broken, block.broken, 512);
    append(sample.held, block.held, 256);
  }

  /// Null where nothing was sampled.
  [[nodiscard]] const PropertySample* find(const Subject& subject, Precision precision,
                                           const Property& property) const {
    const auto place = all_.find({&subject, precision, &property});
    return place == all_.end() ? nullptr : &place->second;
  }

 private:
  std::map<std::tuple<const Subject*, Precision, const Property*>, PropertySample> all_{};
};

/// At most `most` of the cases: of each family in turn, so that the first few are as different as can be.
[[nodiscard]] inline std::vector<Case> in_turn(const std::vector<SeededCase>& cases, std::size_t most) {
  std::map<const Family*, std::size_t> seen;
  std::vector<std::pair<std::size_t, const SeededCase*>> order;
  order.reserve(cases.size());
  for (const SeededCase& one : cases) order.emplace_back(seen[one.family]++, &one);
  std::ranges::stable_sort(order, {}, [](const auto& entry) { return entry.first; });
  std::vector<Case> all;
  for (const auto& [rank, one] : order)
    if (all.size() < most) all.push_back(one->generate());
  return all;
}

}  // namespace rayproof
