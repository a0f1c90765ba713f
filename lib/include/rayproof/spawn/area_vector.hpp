#pragma once
/// \file
/// The vector area of a polygon, good to its last digits however thin the polygon is.

#include <rayproof/arithmetics/growing_expansion.hpp>
#include <rayproof/formulas/polygon_sides.hpp>
#include <rayproof/polygon.hpp>
#include <rayproof/spawn/long_sum.hpp>
#include <vector>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn::detail {

/// b - a in each component, exactly: the difference as rounded, and what was rounded away.
template <std::floating_point T>
struct ExactDifference {
  vec3<T> high, low;

  ExactDifference(const vec3<T>& b, const vec3<T>& a) {
    for (int i = 0; i < 3; ++i) {
      const ErrorFree<T> difference = two_sum(b[i], -a[i]);
      high[i] = difference.rounded;
      low[i] = difference.rest;
    }
  }
};

/// Σ aₖ×bₖ.
template <std::floating_point T>
struct LongNormal {
  LongSum<T> axis[3];

  void add_cross(const ExactDifference<T>& a, const ExactDifference<T>& b) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      for (const auto& [x, y] : {std::pair{&a.high, &b.high}, std::pair{&a.high, &b.low},
                                 std::pair{&a.low, &b.high}, std::pair{&a.low, &b.low}}) {
        axis[i].add_product((*x)[j], (*y)[k]);
        axis[i].add_product(-(*x)[k], (*y)[j]);
      }
    }
  }

  [[nodiscard]] vec3<T> value() const { return {axis[0].value(), axis[1].value(), axis[2].value()}; }
  /// Whether each component is good to 4ε of the whole.
  [[nodiscard]] bool is_clear() const {
    const vec3<T> n = value();
    return axis[0].bound() + axis[1].bound() + axis[2].bound() <= 4 * unit<T> * sqrt(dot(n, n));
  }
};

/// Twice the vector area of a closed polygon of one vertex or more: by sums in twice the digits. Where the
/// vertices are so nearly in a line that these do not suffice, its direction, of length 1, by exact sums.
template <std::floating_point T>
[[nodiscard]] vec3<T> area_vector(const std::vector<vec3<T>>& vertices) {
  const vec3<T>& v0 = vertices.front();
  LongNormal<T> normal;
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
    normal.add_cross({vertices[i], v0}, {vertices[i + 1], v0});
  if (normal.is_clear()) return normal.value();
  using Exact = GrowingExpansion<double>;
  std::vector<Vec3<Exact>> exact;
  for (const vec3<T>& v : vertices) exact.push_back(convert<Exact>(v));
  const Vec3<Exact> n = polygon::newell_normal<Exact>(exact, exact.front());
  const auto nearest = [](const Exact& x) { return estimate(compressed<24>(x)); };
  const glm::dvec3 wide{nearest(n.x), nearest(n.y), nearest(n.z)};
  return convert<T>(1 / sqrt(dot(wide, wide)) * wide);
}

}  // namespace rayproof::spawn::detail

#include <rayproof/rounding/as_before.hpp>
