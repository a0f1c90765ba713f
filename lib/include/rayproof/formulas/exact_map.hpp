#pragma once
/// \file
/// A ray taken into an object's space with nothing rounded.

#include <rayproof/arithmetics/growing_expansion.hpp>
#include <rayproof/formulas/finite.hpp>
#include <rayproof/roots.hpp>
#include <rayproof/transform.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// The factor of a ray that no map has scaled: 1·x is x itself, and no longer.
struct UnitFactor {
  template <class Number>
  friend constexpr const Number& operator*(UnitFactor /*factor*/, const Number& x) {
    return x;
  }
  template <class Number>
  friend constexpr const Vec3<Number>& operator*(UnitFactor /*factor*/, const Vec3<Number>& x) {
    return x;
  }
  friend constexpr int sign(UnitFactor /*factor*/) { return 1; }
};

/// A ray in object space, times the determinant of the map: free of division, by the adjugate of A in place
/// of its inverse. Where the determinant is 0 the vectors mean nothing.
struct ExactlyMapped {
  using Exact = GrowingExpansion<double>;
  Vec3<Exact> origin;
  Vec3<Exact> direction;
  Exact determinant;

  template <std::floating_point T>
  [[nodiscard]] static ExactlyMapped of(const ObjectSpace<T>& space, const Ray<T>& ray) {
    const Vec3<Exact> a = convert<Exact>(space.column_x);
    const Vec3<Exact> b = convert<Exact>(space.column_y);
    const Vec3<Exact> c = convert<Exact>(space.column_z);
    const Vec3<Exact> row_x = cross(b, c), row_y = cross(c, a), row_z = cross(a, b);
    const Exact determinant = dot(a, row_x);
    const Vec3<Exact> p = convert<Exact>(ray.origin) - convert<Exact>(space.translation);
    const Vec3<Exact> d = convert<Exact>(ray.direction);
    return {{dot(row_x, p), dot(row_y, p), dot(row_z, p)},
            {dot(row_x, d), dot(row_y, d), dot(row_z, d)},
            determinant};
  }
};

/// The roots of a ray by a method's `meet(ray, shape, o, d, unit)`, which meets the shape from o along d
/// without rounding; the shape's numbers count `unit` times, as o and d already do.
template <class Method, std::floating_point T, template <class> class Shape>
[[nodiscard]] auto met_exactly(const Ray<T>& ray, const Shape<T>& shape) {
  using Result = decltype(Method::roots(ray, shape));
  if (!are_finite(ray.origin, ray.direction)) return Result(no_hit<T>);  // NOLINT: a miss has no u, v
  return Method::meet(ray, shape, exact_vector<double>(ray.origin), exact_vector<double>(ray.direction),
                      UnitFactor());
}

/// The same under a transform, which is composed with the ray exactly: t is that of the ray and the map as
/// they were given, not of a ray that was rounded into object space. A singular map gives a miss.
template <class Method, std::floating_point T, template <class> class Shape>
[[nodiscard]] auto met_exactly(const ObjectSpace<T>& space, const Ray<T>& ray, const Shape<T>& shape) {
  using Result = decltype(Method::roots(ray, shape));
  if (!are_finite(ray.origin, ray.direction, space.translation, space.column_x, space.column_y,
                  space.column_z))
    return Result(no_hit<T>);  // NOLINT: a miss has no u, v
  const auto [o, d, determinant] = ExactlyMapped::of(space, ray);
  return sign(determinant) == 0 ? Result(no_hit<T>) : Method::meet(ray, shape, o, d, determinant);  // NOLINT
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
