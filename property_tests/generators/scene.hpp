#pragma once
/// \file
/// A ray and a sphere while a generator still works on them, in double; rounded once at the end.

#include <cmath>
#include <limits>
#include <optional>

#include "case/case.hpp"
#include "generators/draw.hpp"

namespace rayproof {

/// Where the pieces of a case are put together.
struct SphereScene {
  glm::dvec3 center{};
  double radius = 1;
  glm::dvec3 origin{};
  glm::dvec3 direction{0, 0, 1};
  double t_min = 0;
  double t_max = std::numeric_limits<double>::infinity();
  std::optional<glm::dmat4> transform{};
};

/// `x` to the nearest `T`.
template <class T>
[[nodiscard]] double round_to(double x) {
  return static_cast<double>(static_cast<T>(x));
}

template <class T>
[[nodiscard]] glm::dvec3 round_to(const glm::dvec3& v) {
  return {round_to<T>(v.x), round_to<T>(v.y), round_to<T>(v.z)};
}

template <class T>
[[nodiscard]] glm::dmat4 round_to(glm::dmat4 m) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) m[column][row] = round_to<T>(m[column][row]);
  return m;
}

/// The question that a scene asks once its numbers are rounded to `T`.
template <class T>
[[nodiscard]] RayQuestion question(const SphereScene& s) {
  RayQuestion asked{
      {round_to<T>(s.origin), round_to<T>(s.direction), round_to<T>(s.t_min), round_to<T>(s.t_max)},
      Sphere<double>{round_to<T>(s.center), round_to<T>(s.radius)}};
  if (s.transform) asked.transform = round_to<T>(*s.transform);
  return asked;
}

/// Puts the origin at `distance` from `target`, looking at it along `sight` (a unit vector), with a direction
/// `length` long.
inline void look_at(SphereScene& scene, const glm::dvec3& target, const glm::dvec3& sight, double distance,
                    double length) {
  scene.origin = target - distance * sight;
  scene.direction = length * sight;
}

/// A sphere of a radius between 0.1 and 5 within a box 20 wide around the origin.
[[nodiscard]] inline SphereScene sphere_in_a_room(Random& random) {
  SphereScene scene;
  scene.center = draw::vector([&] { return random.uniform(-10, 10); });
  scene.radius = random.uniform(0.1, 5);
  return scene;
}

/// The length of a direction: often 1, otherwise between 1/8 and 8.
[[nodiscard]] inline double direction_length(Random& random) {
  return random.one_in(2) ? 1 : std::exp2(random.uniform(-3, 3));
}

}  // namespace rayproof
