#pragma once
/// \file
/// Makes a family's `generate` from a function template over the number type.

#include <utility>

#include "generators/generators.hpp"
#include "generators/random.hpp"

namespace rayproof {

/// The case that `seed` stands for. `Questions` is a family's type, with `template <class T> static Question
/// ask(Random&)` whose numbers are exact in `T`.
template <class Questions>
[[nodiscard]] Case generate(std::uint64_t seed, Precision precision) {
  Random random(seed);
  Case one;
  one.precision = precision;
  one.question = precision == Precision::float32 ? Questions::template ask<float>(random)
                                                 : Questions::template ask<double>(random);
  return one;
}

/// The family that `Questions` describes: its `name`, `description` and `ask`.
template <class Questions>
[[nodiscard]] Family family(const char* topic, std::vector<MinimumShare> shares) {
  return {topic, Questions::name, Questions::description, generate<Questions>, std::move(shares)};
}

}  // namespace rayproof
