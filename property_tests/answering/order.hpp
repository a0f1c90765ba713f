#pragma once
/// \file
/// Which questions a function takes, found by the order of its parameters.

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>

#include "answering/letters.hpp"
#include "answering/problem.hpp"

namespace rayproof::answering {

/// How a function is asked about one shape.
struct Order {
  enum Interval { nowhere, before_shape, after_shape };
  bool is_known = false;        ///< whether it is asked at all
  bool has_ray = false;         ///< a Ray<T>, which has the interval; else origin and direction
  bool has_structure = false;   ///< a Sphere<T>; else its fields
  bool has_transform = false;   ///< is given the transform, last, and the ray in the world
  bool is_flat = false;         ///< no line meets the shape more than once
  Interval interval = nowhere;  ///< of parameters t_min and t_max
};

inline constexpr std::size_t shape_count = std::variant_size_v<Shape>;
using Orders = std::array<Order, shape_count + std::variant_size_v<Question> - 1>;

/// The place of a question's shape in `Orders`, or that of a question without a ray.
[[nodiscard]] inline std::size_t ordinal_of(const Question& question) {
  const auto* asked = std::get_if<RayQuestion>(&question);
  return asked != nullptr ? asked->shape.index() : shape_count + question.index() - 1;
}

/// The pattern with numbers alone: three for a vector.
[[nodiscard]] inline std::string in_numbers(std::string_view pattern) {
  std::string numbers;
  for (const char letter : pattern)
    numbers += letter == 'v'   ? "nnn"
               : letter == 'p' ? "nn"
               : letter == 'a' ? "nnnnnnnnn"
                               : std::string(1, letter);
  return numbers;
}

/// The order in which `given`, a function's pattern, names a ray and `shape`, the pattern of one.
[[nodiscard]] inline Order ray_order(std::string_view given, const std::string& shape) {
  for (const bool has_ray : {true, false}) {
    const std::string ray = has_ray ? "R" : "vv";
    const auto found = [&](Order::Interval interval) {
      return Order{.is_known = true, .has_ray = has_ray, .has_structure = shape == "S", .interval = interval};
    };
    if (given == ray + shape || (!has_ray && given == in_numbers(ray + shape))) return found(Order::nowhere);
    if (given == ray + "nn" + shape) return found(Order::before_shape);
    if (given == ray + shape + "nn") return found(Order::after_shape);
  }
  return {};
}

/// The order in which a function of pattern `given` is asked about the structure `C`.
template <class C, class Parameters>
[[nodiscard]] Order order_for(const std::string& given) {
  constexpr bool has_ray = !requires {
    C{}.point;
    C{}.vertices;
  }
  &&!std::is_same_v<C, Quadratic<double>>;
  constexpr bool is_made = []<class... P>(std::type_identity<std::tuple<P...>>) {
    return ((letter_of<std::decay_t<P>>() == 'S' && is_made_of<std::decay_t<P>, C>()) || ...);
  }(std::type_identity<Parameters>{});
  FieldRow fields;
  const C example{};
  fields.add_fields(example);
  const std::string shape = is_made ? "S" : fields.pattern;
  if constexpr (has_ray) {
    const bool has_transform = given.ends_with('M');
    Order order = ray_order(has_transform ? given.substr(0, given.size() - 1) : given, shape);
    order.has_transform = has_transform;
    const std::string_view type = ShapeFormat<C>::type;
    order.is_flat = type == "plane" || type == "triangle" || type == "polygon";
    return order;
  }
  const bool is_known = given == shape || given == in_numbers(shape);
  return {.is_known = is_known, .has_structure = is_made};
}

/// What stands for "whichever shape the parameters show".
struct Any {};

/// Every question that a function of this pattern takes. Throws std::invalid_argument where there is none.
/// Parameters that fit several shapes mean the first of the case format, and never a plane, whose forms look
/// like other shapes: `takes` names it.
template <class Parameters, class Only>
[[nodiscard]] Orders orders_of(const std::string& given) {
  Orders orders{};
  std::size_t ordinal = 0;
  bool is_found = false;
  each_structure([&]<class C>(std::type_identity<C>) {
    Order& order = orders[ordinal++];
    if constexpr (std::is_same_v<Only, Any> || std::is_same_v<Only, C>) {
      const bool may_be_guessed =
          std::is_same_v<Only, C> || std::string_view(ShapeFormat<C>::type) != "plane";
      const Order candidate = order_for<C, Parameters>(given);
      if (candidate.is_known && (candidate.has_structure || (may_be_guessed && !is_found))) {
        order = candidate;
        is_found = true;
      }
    }
  });
  if (!is_found)
    throw std::invalid_argument("answer_cases: a function takes " + in_words(given) +
                                ", which no shape of the case format has; it may take a ray, or its origin "
                                "and direction, and then a shape or "
                                "its fields, as a vector and a number for a sphere: docs/your-own-code.md, "
                                "'What it is asked', lists them");
  return orders;
}

}  // namespace rayproof::answering
