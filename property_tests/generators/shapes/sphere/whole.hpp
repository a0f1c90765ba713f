#pragma once
/// \file
/// Spheres whose radius and some of whose points are whole, and rays through two of these or touching at one:
/// the discriminant is a square, and each t is whole.

#include <array>
#include <numeric>

#include "generators/shapes/sphere/aimed.hpp"
#include "generators/whole.hpp"

namespace rayproof::sphere_family {

/// The whole vector without its components' common factor.
[[nodiscard]] inline glm::dvec3 primitive(const glm::dvec3& v) {
  const int factor = std::gcd(std::gcd(static_cast<int>(v.x), static_cast<int>(v.y)), static_cast<int>(v.z));
  return factor == 0 ? v : 1.0 / factor * v;
}

/// The vector with its components in another order and with other signs.
[[nodiscard]] inline glm::dvec3 rearranged(Random& random, const glm::dvec3& v) {
  const int first = random.between(0, 2), turn = random.between(1, 2);
  glm::dvec3 result{};
  for (int k = 0; k < 3; ++k) result[k] = (random.one_in(2) ? -1 : 1) * v[(first + (k + 1) * turn) % 3];
  return result;
}

/// A point of the sphere around 0 to which `p` is mirrored, along an axis or by exchanging two coordinates:
/// the way there is along an axis or a diagonal, and its square a power of two times a square.
[[nodiscard]] inline glm::dvec3 mirrored(Random& random, glm::dvec3 p) {
  const int i = random.between(0, 2), j = (i + 1) % 3;
  if (random.one_in(2)) {
    p[i] = -p[i];
  } else {
    std::swap(p[i], p[j]);
  }
  return p;
}

/// A whole direction at right angles to p, in a coordinate plane.
[[nodiscard]] inline glm::dvec3 across(Random& random, const glm::dvec3& p) {
  const int i = random.between(0, 2), j = (i + 1) % 3;
  glm::dvec3 d(0);
  d[i] = p[j];
  d[j] = -p[i];
  if (d == glm::dvec3(0)) d[i] = 1;  // p lies on the third axis
  return primitive(d);
}

[[nodiscard]] inline Scene whole_numbers(Random& random) {
  static constexpr std::array points{glm::dvec3(1, 2, 2), glm::dvec3(0, 3, 4), glm::dvec3(2, 3, 6),
                                     glm::dvec3(1, 4, 8), glm::dvec3(0, 0, 1), glm::dvec3(0, 0, 4)};
  const glm::dvec3 some = points.at(static_cast<std::size_t>(random.between(0, points.size() - 1)));
  const bool is_a_point = random.one_in(16);
  const glm::dvec3 first = is_a_point ? glm::dvec3(0) : rearranged(random, some);
  const glm::dvec3 second = random.one_in(2) ? mirrored(random, first) : rearranged(random, first);
  const bool touches = first == second || random.one_in(4);
  const glm::dvec3 direction = touches ? across(random, first) : primitive(second - first);
  const double beside = touches && random.one_in(3) ? (random.one_in(2) ? 1.25 : 0.75) : 1;
  const double steps = random.between(-3, 5), size = std::exp2(random.between(-2, 2));
  const glm::dvec3 center = whole_point(random, 4);
  return {size * (center + beside * first - steps * direction), size * direction,
          Ball{size * center, is_a_point ? 0 : size * std::sqrt(dot(some, some))}, steps};
}

}  // namespace rayproof::sphere_family
