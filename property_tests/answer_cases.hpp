#pragma once
/// \file
/// Makes a program that can be put on trial of any C++ function that meets a ray with a shape:
///
///     int main() { return rayproof::answer_cases(my_ray_sphere); }
///
/// What the function is asked follows from its parameters, what it says from its result;
/// docs/your-own-code.md has the rules. Needs GLM and the headers of the library, nothing to link.

#include <exception>
#include <iostream>
#include <memory>
#include <utility>
#include <vector>

#include "answering/function.hpp"
#include "answering/loop.hpp"
#include "answering/read.hpp"

namespace rayproof {

/// A function for the shape `S` of the case format (`ImplicitPlane`, `Sphere<double>`, …), with options of
/// its own; made by `takes`.
template <class S, class F>
struct FunctionFor {
  F function;
  answering::FunctionOptions options{};
};

/// Says which shape a function is about where its parameters do not: `takes<PointNormalPlane>(my_plane)`.
template <class S, class F, std::same_as<Option>... O>
[[nodiscard]] FunctionFor<S, std::decay_t<F>> takes(F&& function, O... options) {
  FunctionFor<S, std::decay_t<F>> made{std::forward<F>(function)};
  (made.options.set(options), ...);
  return made;
}

/// A function with options of its own: `with(my_sphere, unit_direction)`.
template <class F, std::same_as<Option>... O>
[[nodiscard]] auto with(F&& function, O... options) {
  return takes<answering::Any>(std::forward<F>(function), options...);
}

namespace answering {

/// Functions that answer cases together: each those of its shapes and of its precision.
class FunctionPanel {
 public:
  /// The options are those of all functions.
  explicit FunctionPanel(FunctionOptions options) : options_(options) {}

  void add(Option /*has been read*/) {}
  template <class F>
  void add(F function) {
    add(FunctionFor<Any, F>{std::move(function)});
  }
  template <class S, class F>
  void add(FunctionFor<S, F> given) {
    static_assert(
        Function<F>,
        "answer_cases: this is no function, function object or lambda with parameters of its own (no "
        "template, no auto, no overloads): wrap it in a lambda such as [](glm::vec3 origin, glm::vec3 "
        "direction, glm::vec3 center, float radius) { ... }; docs/your-own-code.md, 'What it is asked', has "
        "the parameters");
    if constexpr (Function<F>) add_function(std::move(given));
  }

  /// Answers a line of the case format by a line.
  void answer(std::string_view line, std::string& out) {
    reply_.clear();
    one_.question = {};
    try {
      read_line(line, one_);
      Answering* const member = find(one_);
      reply_.is_unsupported = member == nullptr;
      if (member != nullptr) member->answer(one_, reply_);
    } catch (const Unsupported&) {
      reply_.clear();
      reply_.is_unsupported = true;
    } catch (const std::exception& problem) {
      reply_.clear();
      reply_.error = problem.what();
    }
    append_reply(out, one_.id, reply_, std::holds_alternative<Quadratic<double>>(one_.question));
  }

 private:
  template <class S, class F>
  void add_function(FunctionFor<S, F> given) {
    FunctionOptions both = given.options;
    for (const auto& [member, option] :
         {std::pair(&FunctionOptions::needs_unit_direction, Option::unit_direction),
          std::pair(&FunctionOptions::has_no_interval, Option::no_interval),
          std::pair(&FunctionOptions::sees_whole_line, Option::whole_line),
          std::pair(&FunctionOptions::has_no_transform, Option::no_transform)})
      if (options_.*member) both.set(option);
    members_.push_back(std::make_unique<AnsweringFunction<F, S>>(std::move(given.function), both));
  }

  /// The function for a case: one of its precision, or else one of double, which takes floats as they are.
  [[nodiscard]] Answering* find(const Case& one) const {
    Answering* wider = nullptr;
    for (const auto& member : members_) {
      if (!member->takes(one.question)) continue;
      if (member->precision() == one.precision) return member.get();
      if (member->precision() == Precision::float64 && wider == nullptr) wider = member.get();
    }
    return wider;
  }

  FunctionOptions options_;
  std::vector<std::unique_ptr<Answering>> members_{};
  Case one_{};
  FunctionReply reply_{};
};

/// The panel of the functions given; the options among them hold for all.
template <class... G>
[[nodiscard]] FunctionPanel panel_of(G... given) {
  FunctionOptions options;
  const auto read = [&options](const auto& one) {
    if constexpr (std::is_same_v<std::decay_t<decltype(one)>, Option>) options.set(one);
  };
  (read(given), ...);
  FunctionPanel panel(options);
  (panel.add(std::move(given)), ...);
  return panel;
}

}  // namespace answering

/// Answers the cases on standard input by the given functions until it is closed; the program's exit status.
/// Arguments are functions, what `takes` and `with` make of them, and options that hold for all functions.
template <class... G>
[[nodiscard]] int answer_cases(G... given) {
  try {
    answering::FunctionPanel panel = answering::panel_of(std::move(given)...);
    answering::answer_lines(STDIN_FILENO, STDOUT_FILENO,
                            [&panel](std::string_view line, std::string& out) { panel.answer(line, out); });
    return 0;
  } catch (const std::exception& problem) {
    std::cerr << problem.what() << '\n';
    return 2;
  }
}

}  // namespace rayproof
