#pragma once
/// \file
/// Families of cases, each aimed at one kind of difficulty.

#include <cstdint>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "generators/random.hpp"

namespace rayproof {

/// How often a family must produce what it is for: at least `share` of its cases bear `label` (see
/// labels.hpp). Tests fail where a share is missed: a generator that misses its aim tests nothing.
struct MinimumShare {
  std::string label;
  double share = 0;
};

/// What a family owes that is to stay inside the domain of the contracts.
inline const MinimumShare in_reach{"in reach", 0.95};

/// A source of random cases of one kind.
struct Family {
  std::string name;         ///< "grazing"
  std::string description;  ///< one line: what makes it hard
  /// A random question of numbers that the precision has.
  Question (*ask)(Random&, Precision) = nullptr;
  std::vector<MinimumShare> shares{};
  std::string topic{};  ///< "sphere"; given by the registry
  /// Hard alone for who has more digits than the format: a guest is asked it where the family is named.
  bool is_beyond_the_digits = false;

  /// The case that the seed stands for; the same seed always gives the same case.
  [[nodiscard]] Case generate(std::uint64_t seed, Precision precision) const {
    Random random(seed);
    return {.precision = precision, .question = ask(random, precision)};
  }
};

/// Every family, in the order of the registries. The first of a topic that breaks a property gives the
/// counterexample: those that show most come first.
[[nodiscard]] const std::vector<Family>& families();

}  // namespace rayproof
