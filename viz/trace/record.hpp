#pragma once
/// \file
/// Reading the tape of a recorded kernel: formulas, and what its operations lost; and running a method in the
/// recording arithmetic, which makes its walkthrough.

#include <optional>
#include <rayproof/arithmetics/recorded.hpp>
#include <rayproof/arithmetics/recording.hpp>
#include <rayproof/method/contract.hpp>
#include <rayproof/roots.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "viz/trace/expression.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/trace/walkthrough.hpp"

namespace rayproof::viz {

using Tape = Recording<Shadow>;

/// What the operation computes, in the names the kernel gave: "b·b − 4·a·c". Does not stop at its own name.
[[nodiscard]] Formula formula_of(const Tape& tape, OperationId id);

/// The operation that loses most on the path from the inputs to `result`, found by following, from the result
/// backwards, the operand through which the most error came. Nothing where no operation on that path loses
/// `least_bits` bits or more.
[[nodiscard]] std::optional<PrecisionLoss> find_decisive_loss(const Tape& tape, OperationId result,
                                                              double least_bits);

/// Losses below this many bits are the everyday rounding of a few operations.
inline constexpr double noteworthy = 3;
/// The operation that loses most; nothing where none loses a noteworthy number of bits. `arrived` is what the
/// numbers lost that the operations arrive at: an operation whose result lost more than they did was made
/// good, as compensated sums and products do, and is not meant.
[[nodiscard]] std::optional<PrecisionLoss> worst_loss_of(const Tape& tape,
                                                         const std::vector<OperationId>& operations,
                                                         double arrived = infinity<double>);

/// The walkthrough of a tape whose kernel ended in the given numbers.
struct Ending {
  OperationId discriminant, lo, hi;
};
[[nodiscard]] Walkthrough walkthrough_of(const Tape& tape, const Ending& ending, Precision precision);

/// The same of a tape that ends in no answer: its inputs, its steps, and where most was lost.
[[nodiscard]] Walkthrough steps_of(const Tape& tape, Precision precision);

/// A method whose kernel takes any arithmetic; one written for plain floating point alone can't be recorded.
template <class Method, class T>
concept Recordable = requires {
  typename std::type_identity<decltype(&Method::template roots<T>)>::type;
};

/// The walkthrough of a method in the recording arithmetic R; see walk_in.
template <class Topic, class Method, class R, class Build>
[[nodiscard]] Walkthrough walk_of(Precision precision, Build&& build) {
  Tape tape;
  const auto problem = build(std::type_identity<R>{});
  const Roots<R> roots = Topic::template solve<Method>(problem);
  Walkthrough walk = walkthrough_of(tape, {roots.discriminant.id, roots.lo.id, roots.hi.id}, precision);
  walk.title = std::string(Topic::name) + "/" + Method::name + ": " + Method::title;
  walk.known_fault = std::string(Method::contract.refuted.front().because);
  walk.is_printed = Method::contract.standing == Standing::printed;
  walk.source = std::string(Method::source.author) + ", " + std::string(Method::source.title) + ", " +
                std::to_string(Method::source.year);
  return walk;
}

/// The walkthrough of one method of a topic. `build(std::type_identity<R>{})` gives the topic's problem in
/// the recording arithmetic R with its inputs named; it is called while the tape runs.
template <class Topic, class T, class Build>
[[nodiscard]] std::optional<Walkthrough> walk_in(const std::string& method, Precision precision,
                                                 Build&& build) {
  using R = Recorded<T, Shadow>;
  std::optional<Walkthrough> walk;
  Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
    if constexpr (Recordable<Method, R>) {
      // In a function of its own: what does not depend on the method is compiled for topics that no method of
      // takes R.
      if (method == Method::name) walk = walk_of<Topic, Method, R>(precision, build);
    }
  });
  return walk;
}

/// The same in the case's own precision.
template <class Topic, class Build>
[[nodiscard]] std::optional<Walkthrough> walk_topic(const std::string& method, Precision precision,
                                                    Build&& build) {
  return in_precision(precision, [&]<class T>(T) { return walk_in<Topic, T>(method, precision, build); });
}

}  // namespace rayproof::viz
