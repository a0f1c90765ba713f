#pragma once
/// \file
/// A case as a problem of the library, in any arithmetic. A topic that is no shape specialises `Reading`.

#include <utility>
#include <vector>

#include "subjects/subject.hpp"

namespace rayproof {

/// What a subject's adapter needs of a topic:
///  - `problem<A>(case)`: the topic's Problem<A>, the case's numbers exactly, rays taken to object space in
///  arithmetic A;
///  - `answer<Method, T>(case, result)`: what a kernel returned as an answer to the case (T is float or
///  double);
///  - `batch_roots<Method, T>(case)`: the roots by the batch kernels, the case placed among other problems;
///  only of a batched topic.
template <class Topic>
struct Reading;

/// Runs a method on a case in arithmetic `A`, transform included.
template <class Topic, class Method, class A>
[[nodiscard]] auto solve_in(const Case& one) {
  return Topic::template solve<Method, A>(Reading<Topic>::template problem<A>(one));
}

/// `run(T{})` in the case's own precision T.
template <class Run>
[[nodiscard]] auto in_precision(const Case& one, Run&& run) {
  return one.precision == Precision::float32 ? run(float{}) : run(double{});
}

/// Runs a method on a case in the case's own precision.
template <class Topic, class Method>
[[nodiscard]] Answer solve_case(const Case& one) {
  return in_precision(one, [&]<class T>(T) {
    return Answer(Reading<Topic>::template answer<Method, T>(one, solve_in<Topic, Method, T>(one)));
  });
}

/// The same by the library's batch kernels.
template <class Topic, class Method>
[[nodiscard]] Answer solve_case_in_batch(const Case& one) {
  return in_precision(one, [&]<class T>(T) {
    return Answer(Reading<Topic>::template answer<Method, T>(
        one, Reading<Topic>::template batch_roots<Method, T>(one)));
  });
}

}  // namespace rayproof
