#pragma once
/// \file
/// The walkthrough of any method for a ray and a shape: the inputs by name, the map into the shape's own
/// space, and then the kernel's own words.

#include <array>
#include <rayproof/transform.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "case/case.hpp"
#include "viz/trace/record.hpp"

namespace rayproof::viz {

/// The letter by which formulas call a field of the case format; where they have none, the field's own name.
[[nodiscard]] constexpr const char* letter_of(const char* field) {
  constexpr std::array<std::array<const char*, 2>, 5> letters{
      {{"center", "C"}, {"radius", "r"}, {"normal", "n"}, {"point", "p"}, {"d", "D"}}};
  for (const auto& [name, letter] : letters) {
    if (std::string_view(name) == field) return letter;
  }
  return field;
}

/// Names what stands in a field. A flag has no digits to lose and no name.
template <class R, class V>
void name_input(const char* field, V& value) {
  if constexpr (std::is_same_v<V, R> || std::is_same_v<V, vec3<R>>) {
    value = named(letter_of(field), value);
  } else if constexpr (std::is_same_v<V, std::array<vec3<R>, 3>>) {
    constexpr std::array<const char*, 3> letters{"e₀", "e₁", "e₂"};
    for (std::size_t i = 0; i < value.size(); ++i) value[i] = named(letters[i], value[i]);
  } else {
    static_assert(std::is_same_v<V, bool>, "a field of this type can't be named yet");
  }
}

/// A transform's columns by name: the three of its linear part A, and its translation.
template <class R>
[[nodiscard]] std::array<vec3<R>, 4> named_columns(const glm::dmat4& transform) {
  const auto column = [&](const char* name, int i) {
    return named(name, convert<R>(glm::dvec3(transform[i])));
  };
  return {column("A₁", 0), column("A₂", 1), column("A₃", 2), column("T", 3)};
}

/// The ray as the shape's own space sees it, narrated like a step of the method.
template <class R>
[[nodiscard]] Ray<R> in_object_space(const Ray<R>& ray, const glm::dmat4& transform,
                                     const std::string& shape) {
  const auto [a, b, c, translation] = named_columns<R>(transform);
  step<R>(("Take the ray into the " + shape + "'s own space").c_str(),
          "The inverse map applies to o and v; v is not normalised, so t is the same number in both spaces.");
  Ray<R> inside = to_object(object_space<R>(a, b, c, translation), ray);
  inside.origin = named("o′", inside.origin);
  inside.direction = named("d", inside.direction);
  return inside;
}

/// The library's shape of a case's: the same, but for what the format has in several forms.
template <class S>
[[nodiscard]] auto in_library(const S& given) {
  if constexpr (requires { library_shape(given); })
    return library_shape(given);
  else
    return given;
}

/// The case's shape in the recording arithmetic R as the library has it, every field of the format named.
template <class Shape, class R>
[[nodiscard]] Shape recorded_shape(const RayQuestion& question) {
  return std::visit(
      []<class S>(const S& given) -> Shape {
        if constexpr (requires(Shape & to) { to = convert<R>(in_library(given)); }) {
          Shape shape = convert<R>(in_library(given));
          ShapeFormat<S>::fields(shape, [](const char* name, auto& value) { name_input<R>(name, value); });
          return shape;
        } else {
          throw std::logic_error("a case was given to the wrong topic");
        }
      },
      question.shape);
}

/// The walkthrough of a method of a shape's topic.
template <class Topic>
[[nodiscard]] std::optional<Walkthrough> walk_ray(const Case& one, const std::string& method) {
  const auto& question = std::get<RayQuestion>(one.question);
  return walk_topic<Topic>(method, one.precision, [&]<class R>(std::type_identity<R>) {
    using Problem = typename Topic::template Problem<R>;
    using Shape = decltype(Problem::shape);
    Ray<R> ray = convert<R>(question.ray);
    ray.origin = named("o", ray.origin);
    ray.direction = named(question.transform ? "v" : "d", ray.direction);
    const auto shape = recorded_shape<Shape, R>(question);
    if (question.transform) ray = in_object_space(ray, *question.transform, Topic::name);
    return Problem{ray, shape};
  });
}

}  // namespace rayproof::viz
