#pragma once
/// \file
/// Quadratic cases as problems of the library, and its roots as answers.

#include <rayproof/batch/among_neighbours.hpp>
#include <rayproof/quadratic/methods.hpp>

#include "subjects/solve.hpp"

namespace rayproof {

template <>
struct Reading<quadratic::Topic> {
  template <class A>
  [[nodiscard]] static quadratic::Topic::Problem<A> problem(const Case& one) {
    return {convert<A>(convert<Plain<A>>(std::get<Quadratic<double>>(one.question)))};
  }

  template <class Method, class T>
  [[nodiscard]] static Roots<T> batch_roots(const Case& one) {
    return batch::roots_among_neighbours<Method>(problem<T>(one).equation);
  }

  template <class Method, class T>
  [[nodiscard]] static QuadraticAnswer<double> answer(const Case& one, const Roots<T>& roots) {
    const QuadraticAnswer<T> narrow = read(problem<T>(one).equation, roots);
    return {narrow.kind,
            narrow.count,
            {static_cast<double>(narrow.roots[0]), static_cast<double>(narrow.roots[1])}};
  }
};

}  // namespace rayproof
