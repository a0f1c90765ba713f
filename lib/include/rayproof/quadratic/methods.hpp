#pragma once
/// \file
/// The methods for the quadratic equation, one line each.

#include <rayproof/method/topic.hpp>
#include <rayproof/quadratic/citardauq.hpp>
#include <rayproof/quadratic/citardauq_viete.hpp>
#include <rayproof/quadratic/full_range.hpp>
#include <rayproof/quadratic/kahan.hpp>
#include <rayproof/quadratic/printed_b_4ac.hpp>
#include <rayproof/quadratic/textbook.hpp>

namespace rayproof::quadratic {

/// The topic as the registries see it.
struct Topic {
  static constexpr const char* name = "quadratic";
  static constexpr double robust_bound = quadratic_robust_bound;
  static constexpr bool is_batched = true;
  using Methods = TypeList<Textbook, Citardauq, CitardauqViete, Kahan, FullRange, PrintedB4ac>;

  template <class T>
  using Problem = Quadratic<T>;

  /// Runs a method's kernel on a problem, in the problem's arithmetic.
  template <class Method, class T>
  [[nodiscard]] static constexpr Roots<T> solve(const Problem<T>& problem) {
    return Method::roots(problem);
  }
};

}  // namespace rayproof::quadratic
