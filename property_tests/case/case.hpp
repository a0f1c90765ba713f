#pragma once
/// \file
/// A case: one question with the bits of every input number fixed. The currency of the whole suite.

#include <optional>
#include <rayproof/quadratic.hpp>
#include <rayproof/ray.hpp>
#include <string>
#include <string_view>
#include <variant>

#include "case/shapes.hpp"

namespace rayproof {

/// The format a case's numbers and its correctly rounded answers are rounded to.
enum class Precision { float32, float64 };

[[nodiscard]] constexpr const char* name_of(Precision precision) {
  return precision == Precision::float32 ? "float32" : "float64";
}

/// ε, the unit roundoff.
[[nodiscard]] constexpr double roundoff_of(Precision precision) {
  return precision == Precision::float32 ? 0x1p-24 : 0x1p-53;
}

/// The precision of that name; float64 of any other.
[[nodiscard]] constexpr Precision precision_named(std::string_view name) {
  return name == name_of(Precision::float32) ? Precision::float32 : Precision::float64;
}

/// `run(T{})` in the number type T of a precision.
[[nodiscard]] auto in_precision(Precision precision, auto&& run) {
  return precision == Precision::float32 ? run(float{}) : run(double{});
}

/// Where does a ray meet a shape? All numbers are already rounded to the case's precision.
struct RayQuestion {
  Ray<double> ray;
  Shape shape;
  /// Object to world, column-major as GLM has it, affine and regular; the shape in the world is the shape's
  /// image.
  std::optional<glm::dmat4> transform{};
};

/// Written like a shape, its `type` as the case's `query`.
template <>
struct ShapeFormat<Quadratic<double>> {
  static constexpr const char* type = "quadratic";

  static void fields(auto& equation, auto&& visit) {
    visit("a", equation.a);
    visit("b", equation.b);
    visit("c", equation.c);
  }

  static void validate(const Quadratic<double>& /*any finite numbers will do*/) {}
};

/// What can be asked. A new kind of question is a line here.
using Question = std::variant<RayQuestion, Quadratic<double>, PointAndPolygon<double>>;

/// One question, and what it carries along.
struct Case {
  /// The `id` as JSON text ("7", "\"far sphere\""), empty where the case has none.
  std::string id{};
  Precision precision = Precision::float64;
  /// Free text that is carried along and never judged.
  std::string note{};
  Question question{};
};

/// "sphere": the case format's name of the shape's type, which is its topic's, too.
[[nodiscard]] inline std::string shape_name(const Shape& shape) {
  return std::visit([]<class S>(const S&) -> std::string { return ShapeFormat<S>::type; }, shape);
}

/// The case's topic, as in `sphere/centred`: "quadratic", "point_in_polygon", or the shape's type.
[[nodiscard]] inline std::string topic_of(const Case& one) {
  if (const auto* asked = std::get_if<RayQuestion>(&one.question)) return shape_name(asked->shape);
  return std::holds_alternative<Quadratic<double>>(one.question) ? "quadratic" : "point_in_polygon";
}

}  // namespace rayproof
