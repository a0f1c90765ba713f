#pragma once
/// \file
/// Every shape in the form in which it is left; that of most shapes is the shape itself.

#include <rayproof/spawn/flat.hpp>
#include <rayproof/spawn/in_world.hpp>
#include <rayproof/spawn/round.hpp>
#include <rayproof/spawn/slanted.hpp>

namespace rayproof::spawn {

/// Made once for each shape, not for each hit.
template <std::floating_point T>
[[nodiscard]] Flat<T> surface_of(const Plane<T>& plane) {
  return flat_of(plane);
}
template <std::floating_point T>
[[nodiscard]] Flat<T> surface_of(const Triangle<T>& triangle) {
  return flat_of(triangle);
}
template <std::floating_point T>
[[nodiscard]] Flat<T> surface_of(const Polygon<T>& polygon) {
  return flat_of(polygon);
}
template <std::floating_point T>
[[nodiscard]] Slanted<T> surface_of(const Parallelepiped<T>& solid) {
  return slanted(solid);
}
template <std::floating_point T>
[[nodiscard]] Sphere<T> surface_of(const Sphere<T>& sphere) {
  return sphere;
}
template <std::floating_point T>
[[nodiscard]] Box<T> surface_of(const Box<T>& box) {
  return box;
}
template <std::floating_point T>
[[nodiscard]] Cylinder<T> surface_of(const Cylinder<T>& cylinder) {
  return cylinder;
}

/// Whether a surface under a map is one of its own kind in the world.
template <class Surface>
inline constexpr bool can_be_placed = requires(const Surface& surface) {
  place(surface, Placement<decltype(surface.corner.x)>{});
};

/// Whether rays know how to leave a shape.
template <class Shape>
inline constexpr bool can_be_left = requires(const Shape& shape) {
  surface_of(shape);
};

}  // namespace rayproof::spawn
