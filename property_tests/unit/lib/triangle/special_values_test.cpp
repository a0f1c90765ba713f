/// \file
/// Every ray/triangle method on the special values of its arithmetic, named one by one.

#include <gtest/gtest.h>

#include <rayproof/triangle/methods.hpp>

namespace rayproof::triangle {
namespace {

template <class T>
class EveryTriangleMethod : public testing::Test {
 protected:
  static constexpr T nan = not_a_number<T>;

  /// u = 1/4 and v = 1/2 at t = 4.
  const Triangle<T> triangle_{{0, 0, 2}, {4, 0, 2}, {0, 8, 2}};
  const Ray<T> ray_{{1, 4, 0}, {0, 0, T(0.5)}};

  /// Runs `check(hit)` for each method that is not copied with its error.
  template <class Check>
  void for_each_right(const Ray<T>& ray, const Triangle<T>& triangle, Check&& check) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      SCOPED_TRACE(Method::name);
      if constexpr (Method::contract.standing != Standing::printed) check(Method::roots(ray, triangle));
    });
  }

  void expect_t(const Ray<T>& ray, const Triangle<T>& triangle, T t) {
    for_each_right(ray, triangle, [&](const FlatHit<T>& hit) { EXPECT_EQ(nearest(ray, hit), t); });
  }

  void expect_miss(const Ray<T>& ray, const Triangle<T>& triangle) {
    for_each_right(ray, triangle, [&](const FlatHit<T>& hit) { EXPECT_FALSE(any(ray, hit)); });
  }

  void expect_that_even_the_printed_miss(const Ray<T>& ray, const Triangle<T>& triangle) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      SCOPED_TRACE(Method::name);
      EXPECT_FALSE(any(ray, Method::roots(ray, triangle)));
    });
  }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(EveryTriangleMethod, Precisions);

TYPED_TEST(EveryTriangleMethod, MeetsItsInsideWithBarycentricCoordinates) {
  this->for_each_right(this->ray_, this->triangle_, [&](const FlatHit<TypeParam>& hit) {
    EXPECT_EQ(hit.discriminant, 0);
    EXPECT_EQ(hit.lo, 4);
    EXPECT_EQ(hit.hi, 4);
    EXPECT_EQ(hit.u, TypeParam(0.25));
    EXPECT_EQ(hit.v, TypeParam(0.5));
  });
}

TYPED_TEST(EveryTriangleMethod, MeetsEitherSideWhicheverAxisItFaces) {
  using T = TypeParam;
  const auto turn = [](const vec3<T>& p) { return vec3<T>{p.z, p.x, p.y}; };
  Triangle<T> triangle = this->triangle_;
  Ray<T> ray = this->ray_;
  for (int axis = 0; axis < 3; ++axis) {
    SCOPED_TRACE(axis);
    this->expect_t(ray, triangle, 4);
    this->expect_t(ray, {triangle.a, triangle.c, triangle.b}, 4);
    this->expect_t({ray.origin + T(8) * ray.direction, T(-1) * ray.direction}, triangle, 4);
    triangle = {turn(triangle.a), turn(triangle.b), turn(triangle.c)};
    ray = {turn(ray.origin), turn(ray.direction)};
  }
}

TYPED_TEST(EveryTriangleMethod, CountsEdgesAndVertices) {
  using T = TypeParam;
  for (const vec3<T>& point : {vec3<T>{0, 0, 2}, vec3<T>{4, 0, 2}, vec3<T>{0, 8, 2}, vec3<T>{2, 0, 2},
                               vec3<T>{0, 2, 2}, vec3<T>{2, 4, 2}}) {
    this->expect_t({{point.x, point.y, 0}, {0, 0, 1}}, this->triangle_, 2);
  }
}

TYPED_TEST(EveryTriangleMethod, MissesBesideEachEdge) {
  this->expect_miss({{-1, 2, 0}, {0, 0, 1}}, this->triangle_);
  this->expect_miss({{2, -1, 0}, {0, 0, 1}}, this->triangle_);
  this->expect_miss({{3, 4, 0}, {0, 0, 1}}, this->triangle_);
}

TYPED_TEST(EveryTriangleMethod, CountsAnOriginOnTheTriangle) {
  this->expect_t({{1, 4, 2}, {1, 0, 1}}, this->triangle_, 0);
}

TYPED_TEST(EveryTriangleMethod, CountsBothEndsOfTheInterval) {
  Ray<TypeParam> ray = this->ray_;
  ray.t_min = ray.t_max = 4;
  this->expect_t(ray, this->triangle_, 4);
}

TYPED_TEST(EveryTriangleMethod, MissesWhatLiesBehindTheOrigin) {
  Ray<TypeParam> ray = this->ray_;
  ray.direction.z = -1;
  this->expect_that_even_the_printed_miss(ray, this->triangle_);
}

TYPED_TEST(EveryTriangleMethod, TreatsMinusZeroAsZero) {
  using T = TypeParam;
  const T zero(-0.0);
  Ray<T> ray{{zero, zero, zero}, {zero, zero, 1}};
  ray.t_min = zero;
  this->expect_t(ray, this->triangle_, 2);
  this->expect_t(ray, {{zero, zero, 2}, {4, zero, 2}, {zero, 8, 2}}, 2);
}

TYPED_TEST(EveryTriangleMethod, MissesFromInsideItsPlane) {
  this->expect_that_even_the_printed_miss({{-1, 1, 2}, {1, 0, 0}}, this->triangle_);
  this->expect_that_even_the_printed_miss({{1, 1, 2}, {1, 2, TypeParam(-0.0)}}, this->triangle_);
  this->expect_that_even_the_printed_miss({{-1, 1, 1}, {1, 0, 0}}, this->triangle_);
}

TYPED_TEST(EveryTriangleMethod, MissesATriangleWithoutArea) {
  using T = TypeParam;
  const vec3<T> a{1, 4, 2};
  const vec3<T> b{3, 4, 2};
  this->expect_that_even_the_printed_miss(this->ray_, {a, b, {2, 4, 2}});
  this->expect_that_even_the_printed_miss(this->ray_, {a, a, b});
  this->expect_that_even_the_printed_miss(this->ray_, {a, a, a});
}

TYPED_TEST(EveryTriangleMethod, MissesOnADirectionOfZero) {
  this->expect_that_even_the_printed_miss({{1, 4, 0}, {0, 0, 0}}, this->triangle_);
  this->expect_that_even_the_printed_miss({{1, 4, 2}, {0, 0, 0}}, this->triangle_);
}

TYPED_TEST(EveryTriangleMethod, MissesOnNaNAnywhere) {
  for (int i = 0; i < 17; ++i) {
    SCOPED_TRACE(i);
    Ray<TypeParam> ray = this->ray_;
    Triangle<TypeParam> triangle = this->triangle_;
    if (i < 3) ray.origin[i] = this->nan;
    if (i >= 3 && i < 6) ray.direction[i - 3] = this->nan;
    if (i >= 6 && i < 9) triangle.a[i - 6] = this->nan;
    if (i >= 9 && i < 12) triangle.b[i - 9] = this->nan;
    if (i >= 12 && i < 15) triangle.c[i - 12] = this->nan;
    if (i == 15) ray.t_min = this->nan;
    if (i == 16) ray.t_max = this->nan;
    this->expect_that_even_the_printed_miss(ray, triangle);
  }
}

TYPED_TEST(EveryTriangleMethod, PrintedParallelogramMeetsItsOtherHalf) {
  const Ray<TypeParam> ray{{3, 6, 0}, {0, 0, 1}};
  EXPECT_EQ(nearest(ray, PrintedParallelogram::roots(ray, this->triangle_)), 2);
}

TYPED_TEST(EveryTriangleMethod, PrintedLambda2LosesAPointInside) {
  const Triangle<TypeParam> triangle{{0, 0, 1}, {0, 4, 1}, {4, 0, 1}};
  const Ray<TypeParam> ray{{1, 1, 0}, {0, 0, 1}};
  EXPECT_FALSE(any(ray, PrintedLambda2::roots(ray, triangle)));
  this->expect_t(ray, triangle, 1);
}

TYPED_TEST(EveryTriangleMethod, PrintedXyLosesAnUprightTriangle) {
  const Triangle<TypeParam> upright{{2, 0, 0}, {2, 4, 0}, {2, 0, 8}};
  const Ray<TypeParam> ray{{0, 1, 4}, {1, 0, 0}};
  EXPECT_FALSE(any(ray, PrintedXy::roots(ray, upright)));
  this->expect_t(ray, upright, 2);
}

}  // namespace
}  // namespace rayproof::triangle
