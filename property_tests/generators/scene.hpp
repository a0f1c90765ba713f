#pragma once
/// \file
/// A ray and a shape while a generator still works on them, in double; rounded once at the end.

#include <cmath>
#include <limits>
#include <optional>

#include "case/case.hpp"
#include "case/each_number.hpp"
#include "generators/draw.hpp"

namespace rayproof {

/// The ray's side of a scene.
struct RayScene {
  glm::dvec3 origin{};
  glm::dvec3 direction{0, 0, 1};
  double t_min = 0;
  double t_max = std::numeric_limits<double>::infinity();
  std::optional<glm::dmat4> transform{};
  double aimed_at = 0;  ///< the t of the point that the ray was aimed at
};

/// Where the pieces of a case are put together.
struct Scene : RayScene {
  Shape shape{};
};

/// `x` to the nearest `T`.
template <class T>
[[nodiscard]] double round_to(double x) {
  return static_cast<double>(static_cast<T>(x));
}

/// A vector, list or shape with every number rounded to the nearest `T`.
template <class T, class V>
[[nodiscard]] V rounded(V value) {
  each_number(value, [](double& x) { x = round_to<T>(x); });
  return value;
}

template <class T>
[[nodiscard]] glm::dmat4 round_to(glm::dmat4 m) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) m[column][row] = round_to<T>(m[column][row]);
  return m;
}

/// The question that a ray and a shape ask once their numbers are rounded to `T`.
template <class T, class S>
[[nodiscard]] RayQuestion question(const RayScene& s, const S& shape) {
  RayQuestion asked{
      {rounded<T>(s.origin), rounded<T>(s.direction), round_to<T>(s.t_min), round_to<T>(s.t_max)},
      rounded<T>(shape)};
  if (s.transform) asked.transform = round_to<T>(*s.transform);
  return asked;
}

template <class T>
[[nodiscard]] RayQuestion question(const Scene& scene) {
  return std::visit([&](const auto& shape) { return question<T>(scene, shape); }, scene.shape);
}

}  // namespace rayproof
