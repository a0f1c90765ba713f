#pragma once
/// \file
/// The map that places an object in the world, with what leaving the object asks of it.

#include <rayproof/spawn/surface_point.hpp>
#include <rayproof/transform.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn {

/// An object-to-world map q ↦ A·q + b and its inverse, and what every hit asks of their sizes.
template <class T>
struct Placement {
  vec3<T> column_x, column_y, column_z;  ///< of A
  ObjectSpace<T> inverse;
  T shrinks;                       ///< the Frobenius norm of A's inverse
  vec3<T> row_lengths;             ///< of A's inverse
  vec3<T> column_sums;             ///< of each column of A the sum of magnitudes
  vec3<T> row_sums;                ///< the same of each row of A's inverse
  vec3<T> size_x, size_y, size_z;  ///< the magnitudes of A, column by column
  vec3<T> sizes;                   ///< those of b

  [[nodiscard]] constexpr vec3<T> direction(const vec3<T>& v) const {
    return v.x * column_x + v.y * column_y + v.z * column_z;
  }
  /// |A|·v of a v without negative components.
  [[nodiscard]] constexpr vec3<T> spread(const vec3<T>& v) const {
    return v.x * size_x + v.y * size_y + v.z * size_z;
  }
};

template <class To, class From>
[[nodiscard]] constexpr Placement<To> convert(const Placement<From>& from) {
  return {convert<To>(from.column_x),    convert<To>(from.column_y), convert<To>(from.column_z),
          convert<To>(from.inverse),     To(from.shrinks),           convert<To>(from.row_lengths),
          convert<To>(from.column_sums), convert<To>(from.row_sums), convert<To>(from.size_x),
          convert<To>(from.size_y),      convert<To>(from.size_z),   convert<To>(from.sizes)};
}

/// The placement by an affine object-to-world matrix, whose last row is (0, 0, 0, 1). Made once for all hits;
/// of a matrix without inverse its numbers are infinite or NaN, and so are the origins of the rays that leave
/// by it.
template <std::floating_point T>
[[nodiscard]] Placement<T> placement(const glm::mat<4, 4, T>& object_to_world) {
  const ObjectSpace<T> inverse = object_space<T>(object_to_world);
  const auto length = [](const vec3<T>& v) { return sqrt(dot(v, v)); };
  const vec3<T> x{object_to_world[0]}, y{object_to_world[1]}, z{object_to_world[2]};
  const auto sums = [](const vec3<T>& a, const vec3<T>& b, const vec3<T>& c) {
    return vec3<T>{sum<T>(magnitudes<T>(a)), sum<T>(magnitudes<T>(b)), sum<T>(magnitudes<T>(c))};
  };
  const vec3<T> row_lengths{length(inverse.row_x), length(inverse.row_y), length(inverse.row_z)};
  return {x,
          y,
          z,
          inverse,
          length(row_lengths),
          row_lengths,
          sums(x, y, z),
          sums(inverse.row_x, inverse.row_y, inverse.row_z),
          magnitudes<T>(x),
          magnitudes<T>(y),
          magnitudes<T>(z),
          magnitudes<T>(inverse.translation)};
}

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
