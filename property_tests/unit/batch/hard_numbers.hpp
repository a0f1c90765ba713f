#pragma once
/// \file
/// Hard numbers to compare kernels on, and the kernels.

#include <gtest/gtest.h>

#include <limits>
#include <rayproof/batch.hpp>
#include <rayproof/topics.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "generators/draw.hpp"
#include "generators/random.hpp"
#include "unit/bits.hpp"

namespace rayproof {

/// A coordinate: mostly of a usual scene, else any bits, a number by name, an infinity or NaN.
template <class T>
[[nodiscard]] T hard_number(Random& random) {
  switch (random.between(0, 15)) {
    case 0:
      return draw::bit_pattern<T>(random);
    case 1:
      return draw::special<T>(random);
    case 2:
      return static_cast<T>(random.between(-4, 4));
    case 3:
      return random.one_in(8) ? std::numeric_limits<T>::quiet_NaN() : std::numeric_limits<T>::infinity();
    default:
      return static_cast<T>(3) * draw::symmetric<T>(random);
  }
}

/// `size` hard numbers.
template <class T>
[[nodiscard]] std::vector<T> hard_column(Random& random, std::size_t size) {
  std::vector<T> column(size);
  for (T& x : column) x = hard_number<T>(random);
  return column;
}

/// Calls `check(method, T{}, set)` for every method of a topic, in both precisions, on every instruction set
/// the machine has.
template <class Topic, class Check>
void for_each_kernel(Check&& check) {
  Topic::Methods::for_each([&]<class Method>(std::type_identity<Method> method) {
    using Problem = typename Topic::template Problem<float>;
    const auto* baseline = &batch::kernels_for<Method, Problem>(InstructionSet::baseline);
    for (const InstructionSet set : available_instruction_sets()) {
      const bool is_own = &batch::kernels_for<Method, Problem>(set) != baseline;
      if (set != InstructionSet::baseline && !is_own) continue;
      SCOPED_TRACE(std::string(Method::name) + " on " + std::string(name_of(set)));
      check(method, float{}, set);
      check(method, double{}, set);
    }
  });
}

}  // namespace rayproof
