#pragma once
/// \file
/// Turning the axes so that the one along which a vector is longest comes last, without a branch.

#include <rayproof/arithmetic.hpp>
#include <rayproof/method/narration.hpp>
#include <rayproof/vec3.hpp>
#include <type_traits>

namespace rayproof {

namespace steps {
inline constexpr Step project_along_largest_axis{
    "Project along the normal's largest axis",
    "The coordinate in which n = {n} is largest is left out: this projection keeps the most area."};
}  // namespace steps

/// `yes` where `mask` holds, `no` elsewhere, component by component.
template <class T>
[[nodiscard]] constexpr vec3<T> select_vector(const Mask<T>& mask, const std::type_identity_t<vec3<T>>& yes,
                                              const std::type_identity_t<vec3<T>>& no) {
  return vec3<T>{select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

/// The cyclic order of the axes in which a given vector's largest component (in magnitude; ties: the later
/// axis) is the last. Dropping that last coordinate is the projection along the axis.
template <class T>
class LargestAxisLast {
 public:
  /// `v` may be of another arithmetic than the vectors to be turned: exact, while they are plain.
  template <class V>
  constexpr explicit LargestAxisLast(const V& v)
      : x_is_largest_(abs(v.x) > abs(v.y) && abs(v.x) > abs(v.z)), y_is_larger_(abs(v.y) > abs(v.z)) {}

  /// The vector's components in this order: (y, z, x), (z, x, y) or (x, y, z).
  [[nodiscard]] constexpr vec3<T> operator()(const vec3<T>& v) const {
    const vec3<T> y_or_z_last = select_vector<T>(y_is_larger_, vec3<T>{v.z, v.x, v.y}, v);
    return select_vector<T>(x_is_largest_, vec3<T>{v.y, v.z, v.x}, y_or_z_last);
  }
  /// The vector's projection along that axis.
  [[nodiscard]] constexpr Vec2<T> dropped(const vec3<T>& v) const {
    const vec3<T> last_is_largest = (*this)(v);
    return {last_is_largest.x, last_is_largest.y};
  }

 private:
  Mask<T> x_is_largest_;
  Mask<T> y_is_larger_;
};

}  // namespace rayproof
