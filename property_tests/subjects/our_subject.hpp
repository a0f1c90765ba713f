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

/// What a method is and promises, and how to run it on cases in their own precision.
template <class Topic, class Method>
[[nodiscard]] Subject our_subject() {
  Subject subject;
  subject.topic = Topic::name;
  subject.name = Method::name;
  subject.title = Method::title;
  subject.source = Method::source;
  subject.contract = Method::contract;
  using Topical = Reading<Topic>;
  subject.answer = [](const Case& one) {
    return in_precision(one.precision, [&]<class T>(T) -> Answer {
      return Topical::template answer<Method, T>(one, solve_in<Topic, Method, T>(one));
    });
  };
  if constexpr (is_batched<Topic>)
    subject.answer_in_batch = [](const Case& one) {
      return in_precision(one.precision, [&]<class T>(T) -> Answer {
        return Topical::template answer<Method, T>(one, Topical::template batch_roots<Method, T>(one));
      });
    };
  if constexpr (Method::contract.holds.contains(Claim::bounded))
    subject.bounded_hits = [](const Case& one) {
      return in_precision(one.precision, [&]<class T>(T) {
        const auto roots = solve_in<Topic, Method, Bounded<T>>(one);
        std::vector<std::pair<double, double>> hits;
        for (const Bounded<T>& root : {roots.lo, roots.hi})
          if (root.value == root.value) hits.emplace_back(root.value, root.error);
        return hits;
      });
    };
  return subject;
}

}  // namespace rayproof
