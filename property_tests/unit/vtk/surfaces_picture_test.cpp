/// \file
/// The picture of docs/surfaces.md: a torus and a bicubic patch by the guaranteed methods, a ray a pixel.
/// RAYPROOF_SURFACES_PICTURE names a PNG to write it to at full size; the test draws it small.

#include <gtest/gtest.h>

#include <cstdlib>
#include <rayproof/implicit/roots.hpp>
#include <rayproof/implicit/torus.hpp>
#include <rayproof/parametric/hits.hpp>

#include "viz/picture/picture.hpp"
#include "viz/picture/raster.hpp"
#include "viz/vtk/picture_png.hpp"

namespace rayproof::viz {
namespace {

using Vector = glm::dvec3;

Vector unit(const Vector& v) { return (1 / std::sqrt(dot(v, v))) * v; }

/// A pixel's answer: nothing there, a normal, or not decided.
struct PixelAnswer {
  bool is_decided = true;
  std::optional<Vector> normal{};
};

PixelAnswer see_torus(const Ray<double>& ray) {
  const implicit::Torus<double> torus{1.0, 0.42};
  const auto roots = implicit::roots(ray, torus);
  if (roots.empty()) return {};
  if (roots[0].status != RootStatus::certain) return {false};
  const Vector p = point_at(ray, roots[0].lo);
  using D = Dual<double>;
  const D x(p.x, 0.0), y(p.y, 0.0), z(p.z, 0.0), w(1);
  return {true, unit({torus(variable(p.x), y, z, w).slope, torus(x, variable(p.y), z, w).slope,
                      torus(x, y, variable(p.z), w).slope})};
}

/// A sheet that folds over itself: lines of sight meet it up to three times.
parametric::BicubicPatch<double> sheet() {
  constexpr std::array<double, 4> across{-1.0, 1.6, -1.6, 1.0};
  constexpr std::array<double, 4> height{-0.6, 1.5, -1.5, 0.6};
  parametric::BicubicPatch<double> patch{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      patch.points[i][j] = {across[i], -0.9 + 0.6 * static_cast<double>(j),
                            height[i] + (j == 1 || j == 2 ? 0.35 : 0.0)};
  return patch;
}

PixelAnswer see_sheet(const Ray<double>& ray) {
  static const auto patch = sheet();
  const auto hits = parametric::hits(ray, patch);
  if (hits.empty()) return {};
  if (!hits[0].is_certain) return {false};
  using D = Dual<double>;
  const auto by_u = patch(variable(hits[0].u), D(hits[0].v, 0.0));
  const auto by_v = patch(D(hits[0].u, 0.0), variable(hits[0].v));
  return {true, unit(cross(Vector(by_u.x.slope, by_u.y.slope, by_u.z.slope),
                           Vector(by_v.x.slope, by_v.y.slope, by_v.z.slope)))};
}

/// The normal's three components as the three colours, darker where the surface turns away.
Rgb colour_of(const PixelAnswer& seen, const Vector& towards_eye) {
  if (!seen.is_decided) return rgb_of(colour_of(Role::claimed).light);
  if (!seen.normal) return rgb_of(colour_of(Role::background).light);
  const double facing = dot(*seen.normal, towards_eye);
  const Vector n = facing < 0 ? -*seen.normal : *seen.normal;
  const double light = 0.6 + 0.4 * std::abs(facing);
  const auto channel = [&](double x) { return static_cast<std::uint8_t>(255 * light * (x + 1) / 2); };
  return {channel(n.x), channel(n.y), channel(n.z)};
}

/// Both surfaces side by side, seen from above at a slant along parallel rays.
Raster surfaces(int height) {
  Raster picture(2 * height, height, rgb_of(colour_of(Role::background).light));
  const Vector towards_eye = unit({0.45, -1, 0.8});
  const Vector right = unit(cross(Vector(0, 0, 1), towards_eye)), up = cross(towards_eye, right);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < 2 * height; ++x) {
      const auto at = [&](int pixel) { return 3.2 * ((pixel + 0.5) / height - 0.5); };
      const Vector origin = at(x % height) * right - at(y) * up + 8.0 * towards_eye;
      const Ray<double> ray{origin, -towards_eye};
      picture.at(x, y) = colour_of(x < height ? see_torus(ray) : see_sheet(ray), towards_eye);
    }
  }
  return picture;
}

TEST(SurfacesPicture, ShowsATorusWithItsHoleAndASheetWithFewUndecidedPixels) {
  const int height = 48;
  const Raster picture = surfaces(height);
  const Rgb background = rgb_of(colour_of(Role::background).light);
  const Rgb undecided = rgb_of(colour_of(Role::claimed).light);
  const auto count = [&](const Rgb& colour) {
    return std::count(picture.pixels.begin(), picture.pixels.end(), colour);
  };
  EXPECT_EQ(picture.at(height / 2, height / 2), background);
  EXPECT_NE(picture.at(height / 2, height * 4 / 5), background);
  EXPECT_NE(picture.at(height * 3 / 2, height / 2), background);
  const auto surface = 2L * height * height - count(background);
  EXPECT_GT(surface, height * height / 3);
  EXPECT_LT(count(undecided), surface / 100);
  if (const char* const path = std::getenv("RAYPROOF_SURFACES_PICTURE")) write_png(surfaces(300), path);
}

}  // namespace
}  // namespace rayproof::viz
