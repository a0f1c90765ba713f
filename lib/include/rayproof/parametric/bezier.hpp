#pragma once
/// \file
/// Bézier patches of any degree: 1 is the bilinear patch, 3 the bicubic one.
///
/// Source: P. de Casteljau's algorithm and the convex hull property as presented by G. Farin, "Curves and
/// Surfaces for CAGD", 5th ed., 2002.

#include <array>
#include <rayproof/parametric/line.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::parametric {

/// b(t) of the Bernstein coefficients b, by repeated interpolation.
template <class T, std::size_t Count>
[[nodiscard]] constexpr T de_casteljau(std::array<T, Count> b, const T& t) {
  const T rest = T(1) - t;
  for (std::size_t last = Count - 1; last > 0; --last)
    for (std::size_t i = 0; i < last; ++i) b[i] = rest * b[i] + t * b[i + 1];
  return b[0];
}

/// (Degree + 1)² control points; points[i][j] belongs to the i-th Bernstein polynomial of u and the j-th
/// of v, so that points[0][0], points[Degree][0], points[0][Degree] and points[Degree][Degree] are the
/// corners r(0, 0), r(1, 0), r(0, 1) and r(1, 1).
template <class P, std::size_t Degree>
struct BezierPatch {
  std::array<std::array<vec3<P>, Degree + 1>, Degree + 1> points;

  template <class T>
  [[nodiscard]] constexpr Vec3<T> operator()(const T& u, const T& v) const {
    return {coordinate(0, u, v), coordinate(1, u, v), coordinate(2, u, v)};
  }

 private:
  template <class T>
  [[nodiscard]] constexpr T coordinate(int axis, const T& u, const T& v) const {
    std::array<T, Degree + 1> along_u, along_v;
    for (std::size_t i = 0; i <= Degree; ++i) {
      for (std::size_t j = 0; j <= Degree; ++j) along_v[j] = T(points[i][j][axis]);
      along_u[i] = de_casteljau(along_v, v);
    }
    return de_casteljau(along_u, u);
  }
};

template <class P>
using BilinearPatch = BezierPatch<P, 1>;
template <class P>
using BicubicPatch = BezierPatch<P, 3>;

}  // namespace rayproof::parametric

#include <rayproof/rounding/as_before.hpp>
