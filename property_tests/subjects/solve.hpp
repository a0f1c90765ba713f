#pragma once
/// \file
/// A case as a problem of the library, in any arithmetic. A topic specialises `Reading`.

#include <utility>
#include <vector>

#include "subjects/subject.hpp"

namespace rayproof {

/// What a subject's adapter needs of a topic:
///  - `problem<T>(case)`: the topic's Problem<T>, rays already in object space (T is float or double);
///  - `answer<T>(case, roots)`: a kernel's roots as an answer to the case.
template <class Topic>
struct Reading;

/// Runs a method on a case in arithmetic `A` over the plain type `T`.
template <class Topic, class Method, class A, class T>
[[nodiscard]] auto solve_in(const Case& one) {
  return Topic::template solve<Method, A>(Reading<Topic>::template problem<T>(one).template as<A>());
}

/// Runs a method on a case in the case's own precision.
template <class Topic, class Method>
[[nodiscard]] Answer solve_case(const Case& one) {
  const auto run = [&]<class T>(T) {
    return Answer(Reading<Topic>::template answer<T>(one, solve_in<Topic, Method, T, T>(one)));
  };
  return one.precision == Precision::float32 ? run(float{}) : run(double{});
}

}  // namespace rayproof
