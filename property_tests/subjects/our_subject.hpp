#pragma once
/// \file
/// A method of the library as a subject.

#include <rayproof/arithmetics/bounded.hpp>

#include "subjects/reading.hpp"

namespace rayproof {

/// Runs a method on a case in arithmetic `A`, transform included.
template <class Topic, class Method, class A>
[[nodiscard]] auto solve_in(const Case& one) {
  return Topic::template solve<Method, A>(Reading<Topic>::template problem<A>(one));
}

/// Runs a method on a case in the case's own precision.
template <class Topic, class Method>
[[nodiscard]] Answer solve_case(const Case& one) {
  return in_precision(one.precision, [&]<class T>(T) -> Answer {
    return Reading<Topic>::template answer<Method, T>(one, solve_in<Topic, Method, T>(one));
  });
}

/// The same by the library's batch kernels.
template <class Topic, class Method>
[[nodiscard]] Answer solve_case_in_batch(const Case& one) {
  return in_precision(one.precision, [&]<class T>(T) -> Answer {
    return Reading<Topic>::template answer<Method, T>(one,
                                                      Reading<Topic>::template batch_roots<Method, T>(one));
  });
}

/// The hits in running-error arithmetic: each t with the bound on its error.
template <class Topic, class Method>
[[nodiscard]] std::vector<std::pair<double, double>> bounded_case(const Case& one) {
  return in_precision(one.precision, [&]<class T>(T) {
    const auto roots = solve_in<Topic, Method, Bounded<T>>(one);
    std::vector<std::pair<double, double>> hits;
    for (const Bounded<T>& root : {roots.lo, roots.hi}) {
      if (root.value == root.value) hits.emplace_back(root.value, root.error);
    }
    return hits;
  });
}

/// What a method is and promises, and how to run it on cases.
template <class Topic, class Method>
[[nodiscard]] Subject our_subject() {
  Subject subject;
  subject.topic = Topic::name;
  subject.name = Method::name;
  subject.title = Method::title;
  subject.source = Method::source;
  subject.contract = Method::contract;
  if constexpr (requires { Method::far_power; }) subject.far_power = Method::far_power;
  subject.answer = solve_case<Topic, Method>;
  if constexpr (is_batched<Topic>) subject.answer_in_batch = solve_case_in_batch<Topic, Method>;
  if constexpr (Method::contract.holds.contains(Claim::bounded))
    subject.bounded_hits = bounded_case<Topic, Method>;
  return subject;
}

/// Every method of a topic, in the order of its list.
template <class Topic>
void append_methods(std::vector<Subject>& subjects) {
  Topic::Methods::for_each(
      [&]<class Method>(std::type_identity<Method>) { subjects.push_back(our_subject<Topic, Method>()); });
}

}  // namespace rayproof
