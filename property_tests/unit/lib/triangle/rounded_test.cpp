/// \file
/// What the correctly rounded ray/triangle method has over the others: every t, u and v rounded once, and a
/// transform composed exactly. Its verdicts are those of watertight_test.cpp.

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <rayproof/triangle/methods.hpp>

namespace rayproof::triangle {
namespace {

template <class T>
class RoundedTriangleIn : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(RoundedTriangleIn, Precisions);

TYPED_TEST(RoundedTriangleIn, RoundsTiesToEven) {
  using T = TypeParam;
  const T most = T(2) / std::numeric_limits<T>::epsilon();  // every second whole number from here is a number
  const Triangle<T> triangle{{-1, -1, most}, {2, -1, most}, {-1, 2, most}};
  EXPECT_EQ(Rounded::roots(Ray<T>{{0, 0, -1}, {0, 0, 1}}, triangle).lo, most);
  EXPECT_EQ(Rounded::roots(Ray<T>{{0, 0, -3}, {0, 0, 1}}, triangle).lo, most + 4);
}

TYPED_TEST(RoundedTriangleIn, RoundsTheCoordinatesOnce) {
  using T = TypeParam;
  const FlatHit<T> hit =
      Rounded::roots(Ray<T>{{1, 2, -1}, {0, 0, 1}}, Triangle<T>{{0, 0, 0}, {7, 0, 0}, {0, 7, 0}});
  EXPECT_EQ(hit.u, T(1) / T(7));
  EXPECT_EQ(hit.v, T(2) / T(7));
}

/// The map's third is no float: a ray that is rounded into object space first loses what decides.
TYPED_TEST(RoundedTriangleIn, ComposesATransformExactly) {
  using T = TypeParam;
  const Triangle<T> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const T scale : {T(3), T(-3)}) {
    const auto third = object_space(glm::scale(glm::mat<4, 4, T>(1), vec3<T>(scale, scale, 3)));
    const auto at = [&](T x, T y) {
      return roots_in_world<Rounded>(third, Ray<T>{{scale * x, scale * y, -5}, {0, 0, 2}}, triangle);
    };
    const T eighth = T(1) / 8;
    EXPECT_EQ(at(eighth, 1 - eighth).lo, T(2.5));  // on the edge u + v = 1
    EXPECT_EQ(at(eighth, 1 - eighth).u, eighth);
    EXPECT_EQ(at(eighth, std::nextafter(1 - eighth, T(2))).discriminant, -1);
    EXPECT_EQ(at(eighth, -std::numeric_limits<T>::min()).discriminant, -1);
    EXPECT_EQ(at(eighth, 0).discriminant, 0);
  }
  const auto flat = object_space(glm::scale(glm::mat<4, 4, T>(1), vec3<T>(1, 0, 1)));
  const Ray<T> ray{{0, 0, -5}, {0, 0, 2}};
  EXPECT_FALSE(any(ray, roots_in_world<Rounded>(flat, ray, triangle)));
}

TEST(RoundedTriangleInDouble, TrustsOnlyWhatIsClear) {
  const Triangle<double> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto is_sure = [&](const Ray<double>& ray) {
    return rounded_roots(ray, Rounded::enclosed(ray, triangle)).is_sure;
  };
  EXPECT_TRUE(is_sure({{0.3, 0.3, -5}, {0.001, 0.002, 1}}));
  EXPECT_TRUE(is_sure({{3, 3, -5}, {0.001, 0.002, 1}}));
  EXPECT_FALSE(is_sure({{0.5, 0.5, -5}, {0, 0, 1}}));        // on an edge
  EXPECT_FALSE(is_sure({{0.3, 0.3, -5}, {0, 0, 1}, 0, 5}));  // ends on the triangle
  EXPECT_FALSE(is_sure({{-1, 0.25, 0}, {1, 0, 0}}));         // in its plane
  EXPECT_FALSE(is_sure({{0.3, 0.3, -5}, {0, 0, infinity<double>}}));
  EXPECT_FALSE(is_sure({{0.3, std::nan(""), -5}, {0, 0, 1}}));
}

}  // namespace
}  // namespace rayproof::triangle
