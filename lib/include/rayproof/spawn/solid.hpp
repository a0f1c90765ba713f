#pragma once
/// \file
/// Leaving a face of a box.

#include <rayproof/box.hpp>
#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/spawn/surface_point.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn {

/// Which of three is smallest; of equals the first.
template <class T>
struct SmallestOf {
  Mask<T> is_x, is_y;

  SmallestOf(const T& x, const T& y, const T& z) : is_x(x <= y && x <= z), is_y(y <= z) {}

  /// The one that belongs to the smallest.
  [[nodiscard]] T operator()(const T& of_x, const T& of_y, const T& of_z) const {
    return select(is_x, of_x, select(is_y, of_y, of_z));
  }
  [[nodiscard]] vec3<T> operator()(const vec3<T>& of_x, const vec3<T>& of_y, const vec3<T>& of_z) const {
    return select_vector<T>(is_x, of_x, select_vector<T>(is_y, of_y, of_z));
  }
  /// `v` with the smallest one's component from `by`.
  [[nodiscard]] vec3<T> replaced(const vec3<T>& v, const vec3<T>& by) const {
    return vec3<T>{select(is_x, by.x, v.x), select(!is_x && is_y, by.y, v.y),
                   select(!is_x && !is_y, by.z, v.z)};
  }
};

/// The point moved straight onto the nearest face, where it is exact; and within the other faces by
/// `resolution`, and by what rounding takes there, so that what goes in near an edge is not outside the next
/// face, however far beside it p was.
template <class T>
[[nodiscard]] constexpr SurfacePoint<T> surface_point(const Box<T>& box, const vec3<T>& p,
                                                      const vec3<T>& resolution) {
  const vec3<T> to_low = magnitudes<T>(p - box.min), to_high = magnitudes<T>(box.max - p);
  const SmallestOf<T> face(min(to_low.x, to_high.x), min(to_low.y, to_high.y), min(to_low.z, to_high.z));
  const auto outward = [](const T& low, const T& high) { return select(high < low, T(1), T(-1)); };
  const auto onto = [](const T& side, const T& low, const T& high) { return select(T(0) < side, high, low); };
  const auto within = [](const T& at, const T& low, const T& high, const T& by) {
    const T few(8 * unit<T>);
    return clamped(at, low + (by + few * abs(low)), high - (by + few * abs(high)));
  };
  const vec3<T> side{outward(to_low.x, to_high.x), outward(to_low.y, to_high.y),
                     outward(to_low.z, to_high.z)};
  const vec3<T> on{onto(side.x, box.min.x, box.max.x), onto(side.y, box.min.y, box.max.y),
                   onto(side.z, box.min.z, box.max.z)};
  const vec3<T> in{within(p.x, box.min.x, box.max.x, resolution.x),
                   within(p.y, box.min.y, box.max.y, resolution.y),
                   within(p.z, box.min.z, box.max.z, resolution.z)};
  const T zero(0);
  const vec3<T> nothing{zero, zero, zero};
  const vec3<T> normal = face.replaced(nothing, side);
  const vec3<T> point = face.replaced(in, on);
  return {p, point, normal, normal, nothing, zero, zero, true};
}

/// How far, along each axis, no point of the solid is from (0, 0, 0).
template <class T>
[[nodiscard]] constexpr vec3<T> outermost(const Box<T>& box, const vec3<T>& /*p*/) {
  return magnitudes<T>(box.min) + magnitudes<T>(box.max);
}

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
