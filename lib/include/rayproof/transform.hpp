#pragma once
/// \file
/// Transformed objects: the ray goes into the object's own space, the answer comes back out.

#include <rayproof/arithmetics/expansion.hpp>
#include <rayproof/arithmetics/sized.hpp>
#include <rayproof/formulas/difference_of_products.hpp>
#include <rayproof/ray.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// The map from the world into an object's space: p ↦ A⁻¹(p - b) for the object-to-world map q ↦ A·q + b.
///
/// But for one factor common to all, the entries of A⁻¹ are good to a few ulps each even where A is badly
/// conditioned: cofactors are formed without cancelling their rounding errors. That factor, the determinant's
/// error, is within a few ε of A's condition, as is what a transformed ray loses to the conditioning of A
/// itself; it never turns the determinant's sign, and with it a normal.
template <class T>
struct ObjectSpace {
  vec3<T> row_x, row_y, row_z;           ///< the rows of A⁻¹
  vec3<T> translation;                   ///< b
  vec3<T> column_x, column_y, column_z;  ///< the columns of A itself, as they were given

  [[nodiscard]] constexpr vec3<T> direction(const vec3<T>& v) const {
    return vec3<T>{dot(row_x, v), dot(row_y, v), dot(row_z, v)};
  }
  [[nodiscard]] constexpr vec3<T> point(const vec3<T>& p) const { return direction(p - translation); }
};

/// a × b, every component within 1.5 ulp.
template <class T>
[[nodiscard]] constexpr vec3<T> cross_compensated(const vec3<T>& a, const vec3<T>& b) {
  return vec3<T>{difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
                 difference_of_products(a.x, b.y, a.y, b.x)};
}

/// a·(b × c), with bc = b × c at hand. In the machine's arithmetics a sum that cancels until its sign is in
/// doubt, with six roundings to each term, is formed again with nothing rounded: 0 is that of a singular map.
template <class T>
[[nodiscard]] constexpr T determinant_of(const vec3<T>& a, const vec3<T>& b, const vec3<T>& c,
                                         const vec3<T>& bc) {
  if constexpr (std::floating_point<T>) {
    const Sized<T> sum = dot(sized<T>(a), sized<T>(bc));
    if (!(abs(sum.value) > T(8) * unit_roundoff<T> * sum.size)) {
      const auto normal = cross(exact_vector<double>(b), exact_vector<double>(c));
      return static_cast<T>(estimate(dot(exact_vector<double>(a), normal)));
    }
    return sum.value;
  } else {
    return dot(a, bc);
  }
}

/// The object space of the map with columns a, b, c and a translation, whose cofactors are bc = b × c, ca and
/// ab. A singular map gives infinities or NaN, and with them a miss.
template <class T>
[[nodiscard]] constexpr ObjectSpace<T> object_space_of_cofactors(const vec3<T>& a, const vec3<T>& b,
                                                                 const vec3<T>& c, const vec3<T>& translation,
                                                                 const vec3<T>& bc, const vec3<T>& ca,
                                                                 const vec3<T>& ab) {
  const T determinant = determinant_of<T>(a, b, c, bc);
  const auto row = [&](const vec3<T>& cofactors) {
    return vec3<T>{cofactors.x / determinant, cofactors.y / determinant, cofactors.z / determinant};
  };
  return {row(bc), row(ca), row(ab), translation, a, b, c};
}

/// The object space of the map with columns a, b, c and a translation.
template <class T>
[[nodiscard]] constexpr ObjectSpace<T> object_space(const vec3<T>& a, const vec3<T>& b, const vec3<T>& c,
                                                    const vec3<T>& translation) {
  return object_space_of_cofactors<T>(a, b, c, translation, cross_compensated<T>(b, c),
                                      cross_compensated<T>(c, a), cross_compensated<T>(a, b));
}

/// The same for an affine object-to-world matrix (last row 0 0 0 1, which is not looked at). Its determinant
/// may neither over- nor underflow: in float, of a uniform scale from 2^-40 to 2^40, in double to 2^±340.
template <std::floating_point T>
[[nodiscard]] constexpr ObjectSpace<T> object_space(const glm::mat<4, 4, T>& object_to_world) {
  return object_space<T>(vec3<T>{object_to_world[0]}, vec3<T>{object_to_world[1]},
                         vec3<T>{object_to_world[2]}, vec3<T>{object_to_world[3]});
}

/// The ray as the object sees it: origin as a point, direction as a vector, and the same t, since the
/// direction is not made a unit vector again.
template <class T>
[[nodiscard]] constexpr Ray<T> to_object(const ObjectSpace<T>& space, const Ray<T>& ray) {
  return {space.point(ray.origin), space.direction(ray.direction), ray.t_min, ray.t_max};
}

/// Whether a method takes the map itself, and composes it with nothing rounded.
template <class Method, class T, class Shape>
inline constexpr bool takes_transforms = requires(const ObjectSpace<T>& space, const Ray<T>& ray,
                                                  const Shape& shape) {
  Method::roots_in_world(space, ray, shape);
};

/// A method's roots for a ray of the world and a shape in its own space: by the map itself where the method
/// takes it, else for the ray rounded into that space.
template <class Method, class T, class Shape>
[[nodiscard]] constexpr auto roots_in_world(const ObjectSpace<T>& space, const Ray<T>& ray,
                                            const Shape& shape) {
  if constexpr (takes_transforms<Method, T, Shape>) {
    return Method::roots_in_world(space, ray, shape);
  } else {
    return Method::roots(to_object(space, ray), shape);
  }
}

/// A normal of the object as the world sees it: by the inverse transpose, then of unit length.
template <class T>
[[nodiscard]] vec3<T> normal_to_world(const ObjectSpace<T>& space, const vec3<T>& normal) {
  return normalized<T>(normal.x * space.row_x + normal.y * space.row_y + normal.z * space.row_z);
}

/// The same space in another arithmetic.
template <class To, class From>
[[nodiscard]] constexpr ObjectSpace<To> convert(const ObjectSpace<From>& space) {
  return {convert<To>(space.row_x),       convert<To>(space.row_y),    convert<To>(space.row_z),
          convert<To>(space.translation), convert<To>(space.column_x), convert<To>(space.column_y),
          convert<To>(space.column_z)};
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
