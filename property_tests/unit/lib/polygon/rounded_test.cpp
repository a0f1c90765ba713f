/// \file
/// What the correctly rounded ray/polygon method has over the others: t rounded once, and a quick phase that
/// knows what it may be trusted with.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <rayproof/polygon/methods.hpp>

namespace rayproof::polygon {
namespace {

template <class T>
class RoundedPolygonIn : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(RoundedPolygonIn, Precisions);

TYPED_TEST(RoundedPolygonIn, RoundsTiesToEven) {
  using T = TypeParam;
  const T most = T(2) / std::numeric_limits<T>::epsilon();  // every second whole number from here is a number
  const Polygon<T> square{{{-1, -1, most}, {2, -1, most}, {2, 2, most}, {-1, 2, most}}};
  EXPECT_EQ(Rounded::roots(Ray<T>{{0, 0, -1}, {0, 0, 1}}, square).lo, most);
  EXPECT_EQ(Rounded::roots(Ray<T>{{0, 0, -3}, {0, 0, 1}}, square).lo, most + 4);
}

TYPED_TEST(RoundedPolygonIn, TakesATouchedSideForAHitHoweverTheNormalLeans) {
  using T = TypeParam;
  // In the plane x + y + z = 3: no axis is the largest in rounded numbers alone.
  const Polygon<T> leaning{{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}};
  const Ray<T> at_side{{T(1.5), T(1.5), -1}, {0, 0, 2}};
  EXPECT_EQ(nearest(at_side, Rounded::roots(at_side, leaning)), T(0.5));
  const Ray<T> beside_it{{T(1.5), std::nextafter(T(1.5), T(2)), -1}, {0, 0, 2}};
  EXPECT_FALSE(any(beside_it, Rounded::roots(beside_it, leaning)));
}

/// The map's third is no float: a ray that is rounded into object space first loses what decides.
TYPED_TEST(RoundedPolygonIn, ComposesATransformExactly) {
  using T = TypeParam;
  const Polygon<T> square{{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
  for (const T scale : {T(3), T(-3)}) {
    const auto third = object_space(glm::scale(glm::mat<4, 4, T>(1), vec3<T>(scale)));
    const auto at = [&](T x, T y) {
      return roots_in_world<Rounded>(third, Ray<T>{{x, y, 0}, {0, 0, scale / 2}}, square);
    };
    const T more = std::nextafter(T(3), T(4)), less = std::nextafter(T(3), T(0));
    for (const T side : {T(3), T(-3)}) {
      EXPECT_EQ(at(side, side).lo, 2);
      EXPECT_EQ(at(side, 0).lo, 2);
      EXPECT_EQ(at(0, side).lo, 2);
    }
    for (const T x : {more, -more}) EXPECT_EQ(at(x, 0).discriminant, -1);
    for (const T y : {more, -more}) EXPECT_EQ(at(0, y).discriminant, -1);
    EXPECT_EQ(at(less, less).lo, 2);
    const Ray<T> level{{0, 0, scale}, {1, 0, 0}};
    EXPECT_FALSE(any(level, roots_in_world<Rounded>(third, level, square)));
  }
  const auto flat = object_space(glm::scale(glm::mat<4, 4, T>(1), vec3<T>(1, 1, 0)));
  const Ray<T> ray{{0, 0, -1}, {0, 0, 1}};
  EXPECT_FALSE(any(ray, roots_in_world<Rounded>(flat, ray, square)));
}

/// Sixteen corners about the z axis, not in one plane, turned so that z stays the largest axis of the normal.
Polygon<float> bowl(float far) {
  Polygon<float> polygon;
  for (int i = 0; i < 16; ++i) {
    const float angle = static_cast<float>(i) * 0.3926991F, radius = i % 3 == 0 ? 0.7F : 1.3F;
    const float x = radius * std::cos(angle), y = radius * std::sin(angle);
    polygon.vertices.push_back({x, y, far + 0.3F * x + 0.1F * y + 0.01F * static_cast<float>(i % 5)});
  }
  return polygon;
}

TEST(EnclosedQuotientOfAPolygon, HoldsTheExactQuotientWithinItsBound) {
  for (const float far : {1.0F, 100.0F, 1e5F}) {
    for (int i = 0; i < 100; ++i) {
      const float aside = static_cast<float>(i) * 0.013F;
      const Ray<float> ray{{aside, 0.3F - aside, -2}, {0.1F * aside, 0.05F, 1}};
      const auto wide_ray = convert<double>(ray);
      const auto polygon = convert<double>(bowl(far));
      const auto exact = ExactQuotient::of(exact_vector<double>(ray.origin),
                                           exact_vector<double>(ray.direction), UnitFactor(), polygon)
                             .ratio();
      for (const bool is_ray_given : {true, false}) {
        const auto quick = EnclosedQuotient<double>::of(wide_ray, polygon, is_ray_given);
        ASSERT_TRUE(quick.is_sure());
        EXPECT_EQ(exact.compare(rayproof::exact(quick.t() - quick.error_of_t())), 1);
        EXPECT_EQ(exact.compare(rayproof::exact(quick.t() + quick.error_of_t())), -1);
      }
    }
  }
}

TEST(EnclosedQuotientOfAPolygon, IsSureOnlyOfAClearNormalAndARayThatIsClearlyNotParallel) {
  const Polygon<double> level{{{0, 0, 2}, {1, 0, 2}, {0, 1, 2}}};
  const Polygon<double> leaning{{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}};
  const auto is_sure = [](const Ray<double>& ray, const Polygon<double>& polygon) {
    return EnclosedQuotient<double>::of(ray, polygon).is_sure();
  };
  EXPECT_TRUE(is_sure({{0, 0, 0}, {0.1, 0.2, 1}}, level));
  EXPECT_FALSE(is_sure({{0, 0, 0}, {0.1, 0.2, 0}}, level));       // parallel
  EXPECT_FALSE(is_sure({{0, 0, 0}, {1, -1, 0x1p-60}}, leaning));  // nearly parallel
  EXPECT_FALSE(is_sure({{0, 0, 0}, {0, 0, 1}}, leaning));         // two axes are as large as z
  EXPECT_FALSE(is_sure({{0, 0, 0}, {0, 0, 1}}, {{{0, 0, 1}}}));   // no plane
}

}  // namespace
}  // namespace rayproof::polygon
