#pragma once
/// \file
/// Many rays against one shape, made from a family's cases, as arrays to be timed.

#include <array>
#include <cmath>
#include <optional>
#include <rayproof/transform.hpp>
#include <vector>

#include "bench/contenders/shape_frame.hpp"
#include "subjects/reading.hpp"

namespace rayproof::report {

/// A batch has one shape and one transform, and every case has its own. So each case is moved by an affine
/// map in its shape's own space until its shape is the first case's, and goes back into the world by the
/// first case's transform: the ray keeps how it lies to the shape. Where that over- or underflows, or where a
/// shape is flat, the first case's ray stands in.
template <template <class> class Shape, class T>
struct ShapeRays {
  std::array<std::vector<T>, 6> column;  ///< origin and direction
  std::vector<T> t;                      ///< the answers
  Shape<T> shape{};
  std::optional<ObjectSpace<T>> space{};

  explicit ShapeRays(const std::vector<Case>& cases) : t(cases.size()) {
    const auto& first = std::get<RayQuestion>(cases.front().question);
    shape = convert<T>(shape_of(first));
    if (first.transform) space = object_space(glm::mat<4, 4, T>(*first.transform));
    for (const Case& one : cases) {
      const Ray<T> ray = convert<T>(carried_over(std::get<RayQuestion>(one.question), first));
      push_back(is_usable(ray) ? ray : convert<T>(first.ray));
    }
  }

  [[nodiscard]] Ray<T> ray(std::size_t i) const {
    return {{column[0][i], column[1][i], column[2][i]}, {column[3][i], column[4][i], column[5][i]}};
  }

 private:
  static Shape<double> shape_of(const RayQuestion& question) {
    return convert<double>(Reading<RayTopic<Shape>>::shape(question));
  }

  static bool is_usable(const Ray<T>& ray) {
    const T size = dot(ray.origin, ray.origin) + dot(ray.direction, ray.direction);
    return std::isfinite(size) && dot(ray.direction, ray.direction) > 0;
  }

  /// The ray of `one`, aimed at the shape of `other` as it was at its own.
  static Ray<double> carried_over(const RayQuestion& one, const RayQuestion& other) {
    const ShapeFrame from = frame_of(shape_of(one));
    const ShapeFrame to = frame_of(shape_of(other));
    const Ray<double> own = one.transform ? to_object(object_space(*one.transform), one.ray) : one.ray;
    const glm::dmat3 map = to.axes * glm::inverse(from.axes);
    Ray<double> ray{to.origin + map * (own.origin - from.origin), map * own.direction};
    if (other.transform) {
      ray.origin = glm::dvec3(*other.transform * glm::dvec4(ray.origin, 1));
      ray.direction = glm::dvec3(*other.transform * glm::dvec4(ray.direction, 0));
    }
    return ray;
  }

  void push_back(const Ray<T>& ray) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      column[i].push_back(ray.origin[axis]);
      column[i + 3].push_back(ray.direction[axis]);
    }
  }
};

}  // namespace rayproof::report
