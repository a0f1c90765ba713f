#pragma once
/// \file
/// Barycentric coordinates of a point in a triangle: q = α·a + β·b + γ·c with α + β + γ = 1.

#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/method/narration.hpp>
#include <rayproof/polygon.hpp>

namespace rayproof::steps {
inline constexpr Step ask_whether_inside{
    "Ask whether the point lies in the triangle",
    "It does where both parameters are at least 0 and their sum is at most 1."};
}  // namespace rayproof::steps

namespace rayproof::triangle {

template <class T>
struct Barycentric {
  T alpha, beta, gamma;
};

/// Whether the point lies in the closed triangle; false where a coordinate is NaN.
template <class T>
[[nodiscard]] constexpr Mask<T> is_inside(const Barycentric<T>& w) {
  return w.alpha >= T(0) && w.beta >= T(0) && w.gamma >= T(0);
}

/// α and β from the equations of x and y, γ = 1 - α - β. NaN or infinite, and never inside, where the
/// triangle has no area.
///
/// Source: P. Drábek, "Geometrie pro počítačovou grafiku", 2017.
template <class T>
[[nodiscard]] constexpr Barycentric<T> barycentric(const Vec2<T>& q, const Vec2<T>& a, const Vec2<T>& b,
                                                   const Vec2<T>& c) {
  const T area = named("D", (b.y - c.y) * (a.x - c.x) - (b.x - c.x) * (a.y - c.y));
  const T alpha = named("α", ((b.y - c.y) * (q.x - c.x) - (b.x - c.x) * (q.y - c.y)) / area);
  const T beta = named("β", ((a.x - c.x) * (q.y - c.y) - (a.y - c.y) * (q.x - c.x)) / area);
  return {alpha, beta, named("γ", T(1) - alpha - beta)};
}

/// Point and triangle along the axis where the triangle's normal is largest, the projection in which the
/// triangle keeps the most of its area. The triangle may turn over in projection; its coordinates stay.
template <class T>
struct Projected {
  Vec2<T> q, a, b, c;

  /// Source: R. Bán, "Számítógépes grafika: Raycasting", 2022.
  [[nodiscard]] static constexpr Projected along_largest(const vec3<T>& normal, const vec3<T>& q,
                                                         const vec3<T>& a, const vec3<T>& b,
                                                         const vec3<T>& c) {
    step<T>(steps::project_along_largest_axis);
    const LargestAxisLast<T> turned(normal);
    return {turned.dropped(q), turned.dropped(a), turned.dropped(b), turned.dropped(c)};
  }
};

}  // namespace rayproof::triangle
