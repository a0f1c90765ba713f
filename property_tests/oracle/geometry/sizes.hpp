#pragma once
/// \file
/// Lengths of vectors and sizes of maps, read from the exact numbers and from the filters' alike: what the
/// units of the contracts are made of.

#include <utility>

#include "oracle/geometry/scene.hpp"
#include "oracle/numbers/exact.hpp"
#include "oracle/numbers/filters.hpp"

namespace rayproof::oracle {

/// What an R is read by.
template <class R>
using NumberOf = decltype(read(std::declval<R>()));

/// |v|².
template <class R>
[[nodiscard]] NumberOf<R> squared_norm(const Vector<R>& v) {
  const NumberOf<R> x = read(v.x), y = read(v.y), z = read(v.z);
  return x * x + y * y + z * z;
}
/// |v|.
template <class R>
[[nodiscard]] NumberOf<R> norm(const Vector<R>& v) {
  using std::sqrt;
  return sqrt(squared_norm(v));
}
/// A long double has room for the squares of all doubles.
[[nodiscard]] inline long double squared_length_of(const glm::dvec3& v) {
  const long double x = v.x, y = v.y, z = v.z;
  return x * x + y * y + z * z;
}
[[nodiscard]] inline long double length_of(const glm::dvec3& v) { return std::sqrt(squared_length_of(v)); }
[[nodiscard]] inline Scaled norm(const glm::dvec3& v) { return Scaled(length_of(v)); }

/// The length of all these vectors' coordinates together, to one part in 2^38: what a size is made of. Notes
/// a doubt of estimates that are together not as good; a coordinate that is nearly 0 may well be unknown.
template <class... Vectors>
[[nodiscard]] long double length_of(const Vector<Estimate>& v, const Vectors&... more) {
  long double squared = 0;
  double radius = 0;
  const auto note = [&](const Estimate& x) {
    const long double number = static_cast<long double>(x.high) + x.low;
    squared += number * number;
    radius = std::max(radius, x.radius());
  };
  const auto note_all = [&](const Vector<Estimate>& w) { note(w.x), note(w.y), note(w.z); };
  note_all(v), (note_all(more), ...);
  const long double length = std::sqrt(squared);
  if (!(radius <= 0x1p-40L * length && std::isfinite(length))) Doubt::note();
  return length;
}
template <class... Vectors>
[[nodiscard]] Scaled length_of(const Vector<Ring>& v, const Vectors&... more) {
  if (v.x.is_exact()) return sqrt((squared_norm(v) + ... + squared_norm(more)));
  const auto estimates = [](const Vector<Ring>& w) {
    return Vector<Estimate>{w.x.estimate(), w.y.estimate(), w.z.estimate()};
  };
  return Scaled(length_of(estimates(v), estimates(more)...));
}

/// |p| + r of a point p with the power |p|² - r² with respect to a circle or a sphere about 0: the point's
/// distance from it is |power| over this sum.
template <class Number>
[[nodiscard]] Number far_side(const Number& power, const Number& radius) {
  using std::abs, std::sqrt;
  return sqrt(abs(power + radius * radius)) + radius;
}

/// The Frobenius norm of a matrix.
template <class R>
[[nodiscard]] NumberOf<R> norm(const Vector<R>& x, const Vector<R>& y, const Vector<R>& z) {
  using std::sqrt;
  return sqrt(squared_norm(x) + squared_norm(y) + squared_norm(z));
}

/// How much a map and its inverse can stretch a vector: the norms of their 3 by 3 parts, the inverse's times
/// the determinant.
template <class R>
struct MapSizes {
  NumberOf<R> forward, backward;

  MapSizes(const glm::dmat4& m, const InverseMap<R>& map)
      : forward(norm(Vector<R>::from(m[0]), Vector<R>::from(m[1]), Vector<R>::from(m[2]))),
        backward(norm(map.row_x, map.row_y, map.row_z)) {}
};

/// The lengths of a ray as the shape's own space has them: |origin| and |direction| without a transform, and
/// with one as large as it can make their parts, times its condition number.
template <class R>
struct RaySizes {
  SizeOf<R> origin, direction;

  RaySizes(const RayQuestion& question, const ObjectRay<R>& ray)
      : origin(length_of(question.ray.origin)), direction(length_of(question.ray.direction)) {
    if (!ray.map) return;
    const glm::dmat4& m = *question.transform;
    const SizeOf<R> backward =
        length_of(ray.map->row_x, ray.map->row_y, ray.map->row_z) / approximate(ray.scale);
    const SizeOf<R> forward = length_of(Vector<R>::from(m[0]), Vector<R>::from(m[1]), Vector<R>::from(m[2]));
    const SizeOf<R> growth = backward * forward * backward;
    origin = growth * (origin + length_of(ray.map->translation));
    direction = growth * direction;
  }
};

}  // namespace rayproof::oracle
