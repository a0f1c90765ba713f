#pragma once
/// \file
/// Contenders over problems that each have a shape of their own, one at a time: what most topics are timed
/// by.

#include <memory>
#include <rayproof/topics.hpp>

#include "bench/contenders/contender.hpp"
#include "subjects/reading.hpp"

namespace rayproof::report {

/// A topic's problems, and a number for each answer so that none can be left out.
template <class Topic, class T>
class Problems {
 public:
  explicit Problems(const std::vector<Case>& cases) : answers_(cases.size()) {
    for (const Case& one : cases) problems_.push_back(Reading<Topic>::template problem<T>(one));
  }

  template <class Method>
  void solve(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      answers_[i] = number(problems_[i], Topic::template solve<Method>(problems_[i]));
      one_at_a_time();
    }
  }

 private:
  using Problem = typename Topic::template Problem<T>;

  static T number(const Problem& problem, const Roots<T>& roots) { return nearest(problem.ray, roots); }
  static T number(const Problem& /*problem*/, Position position) { return static_cast<T>(position); }

  std::vector<Problem> problems_{};
  std::vector<T> answers_;
};

template <class Topic, class T>
[[nodiscard]] std::vector<Contender> problem_contenders_in(const std::vector<Case>& cases) {
  const auto problems = std::make_shared<Problems<Topic, T>>(cases);
  std::vector<Contender> all;
  Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
    all.push_back({Method::name, Arrangement::scalar,
                   [problems](std::size_t count) { problems->template solve<Method>(count); }});
  });
  return all;
}

/// Every method of the topic, one problem at a time; a transform has been undone beforehand.
template <class Topic>
[[nodiscard]] std::vector<Contender> problem_contenders(const std::vector<Case>& cases, Precision precision) {
  return precision == Precision::float32 ? problem_contenders_in<Topic, float>(cases)
                                         : problem_contenders_in<Topic, double>(cases);
}

}  // namespace rayproof::report
