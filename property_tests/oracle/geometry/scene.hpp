#pragma once
/// \file
/// A ray question in the shape's own space, without division: vectors over the oracle's ring, or over
/// estimates.

#include <optional>
#include <type_traits>

#include "case/case.hpp"
#include "oracle/numbers/filters.hpp"

namespace rayproof::oracle {

/// Three numbers of the ring R (the oracle's own, apart from the library's vectors).
template <class R>
struct Vector {
  R x, y, z;

  static Vector from(const glm::dvec3& v) { return {R(v.x), R(v.y), R(v.z)}; }
  static Vector from(const glm::dvec4& v) { return {R(v.x), R(v.y), R(v.z)}; }
  const R& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

  friend Vector operator-(const Vector& v) { return {-v.x, -v.y, -v.z}; }
  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator*(const R& s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
  [[gnu::always_inline]] friend R dot(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
  [[gnu::always_inline]] friend Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

/// to - from. An estimate knows it exactly, as a pair.
template <class R>
[[nodiscard]] Vector<R> step_between(const glm::dvec3& from, const glm::dvec3& to) {
  const auto difference = [](double x, double y) {
    if constexpr (std::is_constructible_v<R, Pair>)
      return R(sum_of(x, -y));
    else
      return R(x) - R(y);
  };
  return {difference(to.x, from.x), difference(to.y, from.y), difference(to.z, from.z)};
}

/// The inverse of an object-to-world matrix as its adjugate and determinant: A⁻¹ = adjugate / determinant.
/// Both are negated where the determinant is certainly negative, so that what it scales keeps its order.
template <class R>
struct InverseMap {
  Vector<R> row_x, row_y, row_z;  ///< of the adjugate
  R determinant;
  Vector<R> translation;

  explicit InverseMap(const glm::dmat4& m)
      : row_x(cross(Vector<R>::from(m[1]), Vector<R>::from(m[2]))),
        row_y(cross(Vector<R>::from(m[2]), Vector<R>::from(m[0]))),
        row_z(cross(Vector<R>::from(m[0]), Vector<R>::from(m[1]))),
        determinant(dot(Vector<R>::from(m[0]), row_x)),
        translation(Vector<R>::from(m[3])) {
    if (certain_sign(determinant).value_or(0) >= 0) return;
    for (Vector<R>* row : {&row_x, &row_y, &row_z}) *row = -*row;
    determinant = -determinant;
  }

  [[nodiscard]] Vector<R> apply(const Vector<R>& v) const {
    return {dot(row_x, v), dot(row_y, v), dot(row_z, v)};
  }
  /// The adjugate's transpose: takes normals of the object to the world (but for the determinant's size).
  [[nodiscard]] Vector<R> apply_transposed(const Vector<R>& n) const {
    return n.x * row_x + n.y * row_y + n.z * row_z;
  }
};

/// The ray in object space, all lengths there multiplied by `scale` (the determinant of the inverse; 1
/// without a transform; positive where its sign is certain). t is the same number in the world, in the
/// object's space and here.
template <class R>
struct ObjectRay {
  Vector<R> origin;     ///< scale · (A⁻¹(o - b))
  Vector<R> direction;  ///< scale · (A⁻¹ d)
  R scale;
  std::optional<InverseMap<R>> map;

  explicit ObjectRay(const RayQuestion& question)
      : origin(Vector<R>::from(question.ray.origin)),
        direction(Vector<R>::from(question.ray.direction)),
        scale(R(1.0)) {
    if (!question.transform) return;
    map.emplace(*question.transform);
    origin = map->apply(origin - map->translation);
    direction = map->apply(direction);
    scale = map->determinant;
  }

  /// A number or vector of the object's space times the scale.
  template <class V>
  [[nodiscard]] V scaled(const V& v) const {
    return map ? scale * v : v;
  }
};

}  // namespace rayproof::oracle
