#pragma once
/// \file
/// A function as something that answers cases.

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "answering/arguments.hpp"
#include "answering/options.hpp"
#include "answering/order.hpp"
#include "answering/results.hpp"

namespace rayproof::answering {

/// Answers the cases of the shapes that it knows; reused from case to case.
class Answering {
 public:
  Answering() = default;
  Answering(const Answering&) = delete;
  Answering& operator=(const Answering&) = delete;
  virtual ~Answering() = default;

  /// Whether the function takes questions of this kind, whatever their numbers.
  [[nodiscard]] virtual bool takes(const Question& question) const = 0;
  /// What the function computes in.
  [[nodiscard]] virtual Precision precision() const = 0;
  /// Answers a case that it takes. May throw what the function throws.
  virtual void answer(const Case& one, FunctionReply& reply) = 0;
};

/// One function, its parameters matched with the case format's shapes when it is made.
template <class F, class Only>
class AnsweringFunction final : public Answering {
  using Parameters = typename Signature<std::decay_t<F>>::Parameters;
  using Result = std::remove_cvref_t<typename Signature<std::decay_t<F>>::Result>;
  static_assert(
      are_given(std::type_identity<Parameters>{}),
      "answer_cases: a parameter is none of those that a case gives: a ray (rayproof::Ray<T>, or origin and "
      "direction), a number (float, double), a vector (glm::vec3, any class with x, y, z), bool, a list of "
      "vectors, a shape of the library, glm::mat4; references that are not const are results. Wrap the "
      "function in a lambda that takes those; docs/your-own-code.md, 'What it is asked', lists them");
  static_assert(show_a_number(std::type_identity<Parameters>{}),
                "answer_cases: no parameter is of float or double, in which the function computes");
  using Number = decltype(first_number(std::type_identity<Parameters>{}));
  static constexpr bool is_t_returned = std::floating_point<Result>;
  static constexpr Says said = []<class... P>(std::type_identity<std::tuple<P...>>) {
    Says all = says<Result>();
    std::size_t numbers = 0;
    ((numbers += is_output<P> && std::floating_point<std::decay_t<P>>), ...);
    ((all = is_output<P> ? all | says_output<std::decay_t<P>>() : all), ...);
    all.all_hits = all.all_hits || (numbers == 2 && !is_t_returned);
    return all;
  }(std::type_identity<Parameters>{});
  static_assert(
      said.verdict || said.t,
      "answer_cases: the function says neither t nor whether there is a hit: it returns bool, a number t, "
      "std::optional, a list of t or a structure with t or hit, or writes t to a float& or double&; "
      "docs/your-own-code.md, 'What it says', lists the results");

 public:
  AnsweringFunction(F function, FunctionOptions options)
      : function_(std::move(function)),
        options_(options),
        orders_(orders_of<Parameters, Only>(pattern_of(std::type_identity<Parameters>{}))) {}

  [[nodiscard]] bool takes(const Question& question) const override {
    return orders_[ordinal_of(question)].is_known;
  }

  [[nodiscard]] Precision precision() const override {
    return std::is_same_v<Number, float> ? Precision::float32 : Precision::float64;
  }

  void answer(const Case& one, FunctionReply& reply) override {
    const Order& order = orders_[ordinal_of(one.question)];
    if (!set_problem(one.question, order)) {
      reply.is_unsupported = true;
      return;
    }
    call(reply);
    if (problem_.asked != nullptr) {
      finish_ray(order, reply);
    } else if (std::holds_alternative<Quadratic<double>>(one.question)) {
      finish_hits(reply, [](double) { return true; });
    } else if (!reply.position) {
      reply.position = reply.is_hit.value_or(false) ? Position::inside : Position::outside;
      reply.is_hit.reset();
    }
  }

 private:
  /// Puts the numbers in the order of the parameters; false where the function cannot be asked.
  bool set_problem(const Question& question, const Order& order) {
    problem_.asked = nullptr;
    problem_.question = &question;
    FieldRow& fields = problem_.fields;
    fields.clear();
    if (const auto* asked = std::get_if<RayQuestion>(&question)) {
      if (!can_answer(*asked, order) ||
          !problem_.set(*asked, options_.needs_unit_direction, order.has_transform))
        return false;
      if (!order.has_ray) {
        fields.add(problem_.ray.origin);
        fields.add(problem_.ray.direction);
      }
      if (order.interval == Order::before_shape) add_interval();
      std::visit([&](const auto& shape) { add_shape(shape, order); }, asked->shape);
      if (order.interval == Order::after_shape) add_interval();
      return true;
    }
    std::visit(
        [&]<class Q>(const Q& query) {
          if constexpr (!std::is_same_v<Q, RayQuestion>) add_shape(query, order);
        },
        question);
    return true;
  }

  void add_shape(const auto& shape, const Order& order) {
    if (!order.has_structure) problem_.fields.add_fields(shape);
  }
  void add_interval() {
    problem_.fields.add(problem_.ray.t_min);
    problem_.fields.add(problem_.ray.t_max);
  }

  [[nodiscard]] bool has_interval(const Order& order) const {
    return (order.has_ray && !options_.has_no_interval) || order.interval != Order::nowhere;
  }

  /// What a function that is not given the interval cannot know of it, it is not asked.
  [[nodiscard]] bool can_answer(const RayQuestion& asked, const Order& order) const {
    if (asked.transform && options_.has_no_transform) return false;
    const auto [t_min, t_max] = std::pair(asked.ray.t_min, asked.ray.t_max);
    const bool knows = has_interval(order);
    const bool is_shown_by_sign = !said.verdict;  // a negative t may be the word for a miss
    if (t_min < 0 && !options_.sees_whole_line && (!knows || is_shown_by_sign)) return false;
    if (knows) return true;
    if (!said.t)
      return t_max == infinity<double> && t_min == (options_.sees_whole_line ? -infinity<double> : 0);
    return said.all_hits || t_min <= 0 || order.is_flat;
  }

  void call(FunctionReply& reply) {
    [&]<class... P>(std::type_identity<std::tuple<P...>>) {
      ArgumentMaker maker{problem_, problem_.fields.row.data()};
      std::tuple<HeldFor<P>...> held{maker.template make<P>()...};
      ResultTaker taker{reply};
      [&]<std::size_t... I>(std::index_sequence<I...>) {
        if constexpr (std::is_void_v<Result>) {
          function_(pass<P>(std::get<I>(held))...);
        } else {
          taker.take(Result(function_(pass<P>(std::get<I>(held))...)));
        }
        if (reply.is_hit == false) return;
        const auto take = [&taker]<class One>(std::type_identity<One>, const auto& output) {
          if constexpr (is_output<One>) taker.take_output(output);
        };
        (take(std::type_identity<P>{}, std::get<I>(held)), ...);
        taker.end_outputs(is_t_returned);
      }
      (std::index_sequence_for<P...>{});
    }(std::type_identity<Parameters>{});
  }

  /// Scales t back, drops what does not count, and takes point and normal to the
  /// world.
  void finish_ray(const Order& order, FunctionReply& reply) {
    const Ray<double>& ray = problem_.asked->ray;
    const double first = reply.hits.empty() ? 0 : reply.hits.front() / problem_.length;
    const bool knows = has_interval(order);
    for (double& t : reply.hits) t = scaled_back(t);
    finish_hits(reply, [&](double t) {
      if (said.verdict && (knows || std::isnan(t))) return true;
      // The one number of a function that is given the interval: what is no word for a miss is its hit.
      if (!said.verdict && !said.all_hits && knows)
        return std::isfinite(t) && (t >= 0 || options_.sees_whole_line);
      // The one hit of a ray is not behind its origin, nor endlessly far; a function that says so is not
      // helped.
      const bool is_behind = t < 0 && !options_.sees_whole_line;
      if (said.verdict && !said.all_hits && (is_behind || std::isinf(t))) return true;
      return ray.t_min <= t && t <= ray.t_max && std::isfinite(t);
    });
    const bool is_of_first = !said.t || (!reply.hits.empty() &&
                                         std::abs(reply.hits.front() - first) <= std::abs(first) * rounding);
    if (!reply.is_hit.value_or(false) || !is_of_first) {
      reply.point.reset();
      reply.normal.reset();
      reply.barycentric.reset();
    }
    if (!problem_.object_space) return;
    if (reply.point) reply.point = glm::dvec3(*problem_.asked->transform * glm::dvec4(*reply.point, 1));
    if (reply.normal && *reply.normal != glm::dvec3(0))
      reply.normal = normal_to_world<double>(*problem_.object_space, *reply.normal);
  }

  /// t in lengths of the case's direction. The ends of the interval stay its ends: that the scaling rounds is
  /// no fault of the function.
  [[nodiscard]] double scaled_back(double t) const {
    const Ray<double>& ray = problem_.asked->ray;
    if (problem_.length == 1) return t;
    t /= problem_.length;
    for (const double end : {ray.t_min, ray.t_max})
      if (std::isfinite(end) && std::abs(t - end) <= rounding * std::abs(end)) return end;
    return t;
  }

  /// Keeps the hits that count, each once; the verdict follows them where the function gives any.
  void finish_hits(FunctionReply& reply, auto&& counts) {
    reply.lists_hits = said.t;
    if (!said.t) return;
    if (reply.is_hit == false) reply.hits.clear();
    std::erase_if(reply.hits, [&](double t) { return !counts(t); });
    reply.hits.erase(std::unique(reply.hits.begin(), reply.hits.end()), reply.hits.end());
    reply.is_hit = !reply.hits.empty();
  }

  static constexpr double rounding = 4 * static_cast<double>(std::numeric_limits<Number>::epsilon());

  F function_;
  FunctionOptions options_;
  Orders orders_;
  Problem problem_{};
};

}  // namespace rayproof::answering
