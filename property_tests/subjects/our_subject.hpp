#pragma once
/// \file
/// A method of the library as a subject.

#include <rayproof/arithmetics/bounded.hpp>
#include <rayproof/arithmetics/checked.hpp>

#include "subjects/reading.hpp"

namespace rayproof {

/// Runs a method on a case in arithmetic `A`, transform included.
template <class Topic, class Method, class A>
[[nodiscard]] auto solve_in(const Case& one) {
  if constexpr (requires { Reading<Topic>::template roots_in_world<Method, A>(one); })
    return Reading<Topic>::template roots_in_world<Method, A>(one);
  else
    return Topic::template solve<Method, A>(Reading<Topic>::template problem<A>(one));
}

/// A method whose kernel takes checked numbers; the exact methods are written for plain ones alone.
template <class Method>
concept Checkable = requires {
  typename std::type_identity<decltype(&Method::template roots<Checked<float>>)>::type;
}
|| requires { typename std::type_identity<decltype(&Method::template locate<Checked<float>>)>::type; };

/// Whether the numbers that an answer is read from are exact; a position is read from decisions alone.
template <class T>
[[nodiscard]] bool is_exact(const Roots<Checked<T>>& roots) {
  return roots.discriminant.is_exact && roots.lo.is_exact && roots.hi.is_exact;
}
[[nodiscard]] inline bool is_exact(Position /*any*/) { return true; }

/// Whether a method rounds nothing on a case in `T`, nor does what its answer is read by.
template <class Topic, class Method, class T>
[[nodiscard]] bool runs_exactly(const Case& one) {
  const RoundedDecision decision;
  const auto problem = Reading<Topic>::template problem<Checked<T>>(one);
  const auto result = Topic::template solve<Method, Checked<T>>(problem);
  if constexpr (requires { problem.ray; })
    (void)Reading<Topic>::template contact_of_miss<Method, Checked<T>>(problem);
  return is_exact(result) && !decision.was_made();
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
  subject.takes_transforms = requires { Topical::template roots_in_world<Method, double>(Case()); };
  subject.answer_by([](const Case& one) {
    return in_precision(one.precision, [&]<class T>(T) -> Answer {
      auto answer = Topical::template answer<Method, T>(one, solve_in<Topic, Method, T>(one));
      if constexpr (has_correction<Method>)
        Topical::template put_nearest_hit<T>(one, answer, [](const auto& ray, const auto& shape) {
          return corrected_hit<Method>(ray, shape);
        });
      return answer;
    });
  });
  if constexpr (is_batched<Topic>)
    subject.answer_in_batch = [](const Case& one) {
      return in_precision(one.precision, [&]<class T>(T) -> Answer {
        auto answer = Topical::template answer<Method, T>(one, Topical::template batch_roots<Method, T>(one));
        if constexpr (has_correction<Method>)
          Topical::template put_nearest_hit<T>(one, answer, [](const auto& ray, const auto& shape) {
            return batch::nearest_among_neighbours<Method>(ray, shape);
          });
        return answer;
      });
    };
  if constexpr (has_correction<Method>) {
    subject.bounded_hits = [](const Case& one) { return Topical::template corrected_hits<Method>(one); };
    subject.is_in_doubt = [](const Case& one) { return Topical::template is_in_doubt<Method>(one); };
  } else if constexpr (Method::contract.holds.contains(Claim::bounded))
    subject.bounded_hits = [](const Case& one) {
      return in_precision(one.precision, [&]<class T>(T) {
        const auto roots = solve_in<Topic, Method, Bounded<T>>(one);
        std::vector<std::pair<double, double>> hits;
        for (const Bounded<T>& root : {roots.lo, roots.hi})
          if (root.value == root.value) hits.emplace_back(root.value, root.error);
        return hits;
      });
    };
  if constexpr (Checkable<Method> && Method::contract.speaks_of(Claim::exact))
    subject.is_exact_on = [](const Case& one) {
      return in_precision(one.precision, [&]<class T>(T) { return runs_exactly<Topic, Method, T>(one); });
    };
  return subject;
}

}  // namespace rayproof
