/// \file
/// What the watertight and the exact ray/triangle methods keep where others let go.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <rayproof/triangle/methods.hpp>

namespace rayproof::triangle {
namespace {

template <class T>
class WatertightTriangle : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(WatertightTriangle, Precisions);

TYPED_TEST(WatertightTriangle, LetsNoRayThroughASharedEdge) {
  using T = TypeParam;
  const std::array<vec3<T>, 4> corner{vec3<T>{T(-0.7), T(-0.9), T(3.1)}, vec3<T>{T(0.9), T(0.3), T(2.7)},
                                      vec3<T>{T(-0.3), T(1.1), T(3.3)}, vec3<T>{T(0.8), T(-1.3), T(2.9)}};
  const Triangle<T> left{corner[0], corner[1], corner[2]};
  const Triangle<T> right{corner[1], corner[0], corner[3]};
  // Not the ends of the edge: beyond them rounding may carry the ray past both triangles.
  for (int i = 1; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const vec3<T> on_edge = corner[0] + T(i) / T(1000) * (corner[1] - corner[0]);
    const Ray<T> ray{{T(0.1), T(0.2), T(-0.3)}, on_edge - vec3<T>{T(0.1), T(0.2), T(-0.3)}};
    EXPECT_TRUE(any(ray, Woop::roots(ray, left)) || any(ray, Woop::roots(ray, right)));
    EXPECT_TRUE(any(ray, Plucker::roots(ray, left)) || any(ray, Plucker::roots(ray, right)));
    EXPECT_TRUE(any(ray, Rounded::roots(ray, left)) || any(ray, Rounded::roots(ray, right)));
  }
}

TYPED_TEST(WatertightTriangle, LetsNoRayThroughTheHubOfAFan) {
  using T = TypeParam;
  constexpr int blades = 7;
  const vec3<T> hub{T(0.1), T(-0.2), T(5.3)};
  const auto rim = [&](int i) {
    const double angle = 0.3 + 2 * 3.14159265358979 * (i % blades) / blades;
    return vec3<T>{T(std::cos(angle)), T(std::sin(angle)), T(5 + 0.1 * (i % blades))};
  };
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const vec3<T> origin{T(0.01) * T(i % 13), T(-0.03) * T(i % 7), T(-0.7)};
    const Ray<T> ray{origin, hub - origin};
    int woop = 0;
    int exact = 0;
    for (int blade = 0; blade < blades; ++blade) {
      const Triangle<T> triangle{hub, rim(blade), rim(blade + 1)};
      woop += any(ray, Woop::roots(ray, triangle)) ? 1 : 0;
      exact += any(ray, Rounded::roots(ray, triangle)) ? 1 : 0;
    }
    EXPECT_GE(woop, 1);
    EXPECT_GE(exact, 1);
  }
}

TYPED_TEST(WatertightTriangle, RoundedComparesTheExactTWithTheEndOfTheInterval) {
  using T = TypeParam;
  Ray<T> ray{{0, 0, 0}, {0, 0, 3}};
  ray.t_max = T(1) / T(3);  // a little more than a third in float, a little less in double
  const bool is_reached = std::is_same_v<T, float>;
  EXPECT_EQ(any(ray, Rounded::roots(ray, {{-1, -1, 1}, {2, -1, 1}, {-1, 2, 1}})), is_reached);
}

TYPED_TEST(WatertightTriangle, RoundedSeesTheLastBitBesideAnEdge) {
  using T = TypeParam;
  const Triangle<T> triangle{{0, 0, 1}, {3, 1, 1}, {0, 1, 1}};
  const T third = T(1) / T(3);  // a little more than a third in float, a little less in double
  const bool is_hit = std::is_same_v<T, float>;
  const Ray<T> ray{{1, third, 0}, {0, 0, 1}};
  EXPECT_EQ(any(ray, Rounded::roots(ray, triangle)), is_hit);
  const Ray<T> from_afar{{1, third, T(-1e6)}, {0, 0, 1}};
  EXPECT_EQ(any(from_afar, Rounded::roots(from_afar, triangle)), is_hit);
}

TEST(RoundedTriangle, BearsTheSmallestAndTheLargestFloats) {
  for (const float size : {std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max()}) {
    const Triangle<float> triangle{{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
    const Ray<float> ray{{0, 0, -size}, {0, 0, size}};
    EXPECT_EQ(nearest(ray, Rounded::roots(ray, triangle)), 1);
  }
}

}  // namespace
}  // namespace rayproof::triangle
