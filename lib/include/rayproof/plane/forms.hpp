#pragma once
/// \file
/// A plane given in one form, read in another. Each conversion rounds to a few ε of the plane's own numbers.

#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/method/narration.hpp>
#include <rayproof/plane.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::plane {

/// normal·q + d = 0.
template <class T>
struct Implicit {
  vec3<T> normal;
  T d;
};

/// normal·(q - point) = 0.
template <class T>
struct PointNormal {
  vec3<T> point;
  vec3<T> normal;
};

/// q = point + a·u + b·v.
template <class T>
struct Parametric {
  vec3<T> point;
  vec3<T> u, v;
};

/// The normal as given, or u × v; not of unit length.
template <class T>
[[nodiscard]] constexpr vec3<T> normal_of(const Plane<T>& plane) {
  return plane.form == PlaneForm::parametric ? cross(plane.u, plane.v) : plane.normal;
}

/// A point of the plane: the given one, or -d·n/|n|², the foot of the perpendicular from the origin; NaN
/// where the normal is 0.
template <class T>
[[nodiscard]] constexpr vec3<T> point_of(const Plane<T>& plane) {
  if (plane.form != PlaneForm::implicit) return plane.point;
  return (-plane.d / dot(plane.normal, plane.normal)) * plane.normal;
}

template <class T>
[[nodiscard]] constexpr Implicit<T> as_implicit(const Plane<T>& plane) {
  if (plane.form == PlaneForm::implicit) return {plane.normal, plane.d};
  step<T>("Write the plane as n·q + D = 0",
          "The points q of the plane satisfy this equation; D follows from the given point.");
  const vec3<T> n = named("n", normal_of(plane));
  return {n, named("D", -dot(n, plane.point))};
}

template <class T>
[[nodiscard]] constexpr PointNormal<T> as_point_normal(const Plane<T>& plane) {
  if (plane.form == PlaneForm::point_normal) return {plane.point, plane.normal};
  step<T>("Find a point and the normal of the plane",
          "Of an implicit plane, p is the point nearest (0, 0, 0); of a parametric plane, n is u × v.");
  return {named("p", point_of(plane)), named("n", normal_of(plane))};
}

/// The first spanning vector of a normal n: n turned by a right angle about y or z, along whichever it is
/// shorter, so that no component is rounded and no more than half of n² is lost. The second is n × u.
template <class T>
[[nodiscard]] constexpr Parametric<T> as_parametric(const Plane<T>& plane) {
  if (plane.form == PlaneForm::parametric) return {plane.point, plane.u, plane.v};
  step<T>("Find a point of the plane and two vectors that span it",
          "u and v lie in the plane: they are perpendicular to its normal and to each other.");
  const vec3<T> n = plane.normal;
  const vec3<T> u =
      named("u", select_vector<T>(abs(n.y) <= abs(n.z), vec3<T>{n.z, T(0), -n.x}, vec3<T>{-n.y, n.x, T(0)}));
  return {named("p", point_of(plane)), u, named("v", cross(n, u))};
}

}  // namespace rayproof::plane

#include <rayproof/rounding/as_before.hpp>
