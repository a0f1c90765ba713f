/// \file
/// Every ray/polygon method on the special values of its arithmetic, named one by one.

#include <gtest/gtest.h>

#include <algorithm>
#include <rayproof/polygon/methods.hpp>

namespace rayproof::polygon {
namespace {

template <class T>
class EveryPolygonMethod : public testing::Test {
 protected:
  static constexpr T nan = not_a_number<T>;

  /// A square with a notch from above down to (2, 1), in the plane z = 2.
  const Polygon<T> notched_{{{0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {2, 1, 2}, {0, 4, 2}}};

  static Ray<T> over(T x, T y) { return {{x, y, 0}, {0, 0, T(0.5)}}; }
  /// The axes in turn: (x, y, z) becomes (z, x, y).
  static vec3<T> turn(const vec3<T>& p) { return {p.z, p.x, p.y}; }

  /// Expects `t` of every method but the printed one, infinity for a miss, whichever axis the polygon faces
  /// and whichever way round it runs.
  void expect_t(Ray<T> ray, Polygon<T> polygon, T t) {
    for (int pose = 0; pose < 6; ++pose) {
      SCOPED_TRACE(pose);
      Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
        SCOPED_TRACE(Method::name);
        if constexpr (!std::is_same_v<Method, PrintedParity>) {
          EXPECT_EQ(nearest(ray, Method::roots(ray, polygon)), t);
        }
      });
      for (vec3<T>& vertex : polygon.vertices) vertex = turn(vertex);
      ray.origin = turn(ray.origin);
      ray.direction = turn(ray.direction);
      if (pose == 2) std::reverse(polygon.vertices.begin(), polygon.vertices.end());
    }
  }

  void expect_that_even_the_printed_miss(const Ray<T>& ray, const Polygon<T>& polygon) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      EXPECT_FALSE(any(ray, Method::roots(ray, polygon))) << Method::name;
    });
  }

  void expect_miss(const Ray<T>& ray, const Polygon<T>& polygon) { expect_t(ray, polygon, infinity<T>); }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(EveryPolygonMethod, Precisions);

TYPED_TEST(EveryPolygonMethod, MeetsTheInsideOfAConcavePolygon) {
  this->expect_t(this->over(1, 1), this->notched_, 4);
  this->expect_t(this->over(3, 1), this->notched_, 4);
  this->expect_miss(this->over(2, 3), this->notched_);
  this->expect_miss(this->over(5, 1), this->notched_);
  this->expect_miss(this->over(-1, 4), this->notched_);
}

TYPED_TEST(EveryPolygonMethod, CountsSidesAndVertices) {
  for (const vec3<TypeParam>& vertex : this->notched_.vertices) {
    this->expect_t(this->over(vertex.x, vertex.y), this->notched_, 4);
  }
  this->expect_t(this->over(1, 0), this->notched_, 4);
  this->expect_t(this->over(4, 3), this->notched_, 4);
  this->expect_t(this->over(3, TypeParam(2.5)), this->notched_, 4);
}

TYPED_TEST(EveryPolygonMethod, FollowsTheEvenOddRuleWhereAPolygonCrossesItself) {
  const Polygon<TypeParam> star{{{0, 5, 2}, {3, -4, 2}, {-5, 2, 2}, {5, 2, 2}, {-3, -4, 2}}};
  this->expect_miss(this->over(0, 0), star);
  this->expect_t(this->over(0, 4), star, 4);
}

TYPED_TEST(EveryPolygonMethod, TakesNoNoticeOfRepeatedVertices) {
  const Polygon<TypeParam> repeated{
      {{0, 0, 2}, {0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {4, 4, 2}, {0, 4, 2}, {0, 0, 2}}};
  this->expect_t(this->over(1, 1), repeated, 4);
  this->expect_t(this->over(4, 4), repeated, 4);
  this->expect_miss(this->over(-1, 0), repeated);
}

TYPED_TEST(EveryPolygonMethod, CountsAnOriginOnThePolygon) {
  this->expect_t({{1, 1, 2}, {1, 0, 1}}, this->notched_, 0);
}

TYPED_TEST(EveryPolygonMethod, CountsBothEndsOfTheInterval) {
  Ray<TypeParam> ray = this->over(1, 1);
  ray.t_min = ray.t_max = 4;
  this->expect_t(ray, this->notched_, 4);
}

TYPED_TEST(EveryPolygonMethod, TreatsMinusZeroAsZero) {
  const TypeParam zero(-0.0);
  this->expect_t({{zero, zero, zero}, {zero, zero, TypeParam(0.5)}}, this->notched_, 4);
}

TYPED_TEST(EveryPolygonMethod, MissesWhatLiesBehindTheOrigin) {
  this->expect_that_even_the_printed_miss({{1, 1, 0}, {0, 0, -1}}, this->notched_);
}

TYPED_TEST(EveryPolygonMethod, MissesFromInsideItsPlaneAndParallelToIt) {
  this->expect_that_even_the_printed_miss({{-1, 1, 2}, {1, 0, 0}}, this->notched_);
  this->expect_that_even_the_printed_miss({{-1, 1, 1}, {1, 0, TypeParam(-0.0)}}, this->notched_);
  this->expect_that_even_the_printed_miss({{1, 1, 2}, {0, 0, 0}}, this->notched_);
}

TYPED_TEST(EveryPolygonMethod, MissesAPolygonWithoutArea) {
  this->expect_that_even_the_printed_miss(this->over(1, 0), {{{0, 0, 2}, {4, 0, 2}, {2, 0, 2}}});
  this->expect_that_even_the_printed_miss(this->over(1, 1), {{{1, 1, 2}, {1, 1, 2}, {1, 1, 2}}});
  const Polygon<TypeParam> bow_tie{{{0, 0, 2}, {4, 4, 2}, {4, 0, 2}, {0, 4, 2}}};  // its halves cancel
  this->expect_that_even_the_printed_miss(this->over(1, 2), bow_tie);
}

TYPED_TEST(EveryPolygonMethod, MissesOnNaNAnywhere) {
  for (int i = 0; i < 3; ++i) {
    SCOPED_TRACE(i);
    Ray<TypeParam> ray = this->over(1, 1);
    ray.origin[i] = this->nan;
    this->expect_that_even_the_printed_miss(ray, this->notched_);
    ray = this->over(1, 1);
    ray.direction[i] = this->nan;
    this->expect_that_even_the_printed_miss(ray, this->notched_);
    for (std::size_t k = 0; k < this->notched_.vertices.size(); ++k) {
      Polygon<TypeParam> polygon = this->notched_;
      polygon.vertices[k][i] = this->nan;
      this->expect_that_even_the_printed_miss(this->over(1, 1), polygon);
    }
  }
  Ray<TypeParam> ray = this->over(1, 1);
  ray.t_min = this->nan;
  this->expect_that_even_the_printed_miss(ray, this->notched_);
  ray = this->over(1, 1);
  ray.t_max = this->nan;
  this->expect_that_even_the_printed_miss(ray, this->notched_);
}

TYPED_TEST(EveryPolygonMethod, ProjectsAlongTheLaterAxisWhereTheNormalTies) {
  using T = TypeParam;
  // Not flat, and its Newell normal is (-16, -32, 32): the plane z = y + x/2. Dropping z leaves the square
  // 0 <= x, y <= 4; dropping y would leave 0 <= z <= 2 + x.
  const Polygon<T> bent{{{0, 0, 0}, {4, 0, 0}, {4, 4, 6}, {0, 4, 2}}};
  const Ray<T> in_square{{2, T(3.5), T(0.5)}, {0, 0, 1}};
  const Ray<T> beside_square{{2, T(-0.5), T(-3.5)}, {0, 0, 1}};
  Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
    SCOPED_TRACE(Method::name);
    EXPECT_EQ(nearest(in_square, Method::roots(in_square, bent)), 4);
    EXPECT_FALSE(any(beside_square, Method::roots(beside_square, bent)));
  });
}

TYPED_TEST(EveryPolygonMethod, RoundedComparesTheExactTWithTheEndOfTheInterval) {
  using T = TypeParam;
  Ray<T> ray{{1, 1, -1}, {0, 0, 9}};
  ray.t_max = T(1) / T(3);  // a little more than a third in float, a little less in double
  EXPECT_EQ(any(ray, Rounded::roots(ray, this->notched_)), (std::is_same_v<T, float>));
}

TYPED_TEST(EveryPolygonMethod, RoundedSeesTheLastBitBesideASide) {
  using T = TypeParam;
  const Polygon<T> polygon{{{0, 0, 2}, {3, 1, 2}, {0, 1, 2}}};
  const T third = T(1) / T(3);  // a little more than a third in float, a little less in double
  const bool is_hit = std::is_same_v<T, float>;
  for (const T height : {T(0), T(-1e6)}) {
    const Ray<T> ray{{1, third, height}, {0, 0, 1}};
    EXPECT_EQ(any(ray, Rounded::roots(ray, polygon)), is_hit);
  }
}

TYPED_TEST(EveryPolygonMethod, PrintedParityCountsAVertexTwice) {
  const Polygon<TypeParam> diamond{{{0, -2, 2}, {2, 0, 2}, {0, 2, 2}, {-2, 0, 2}}};
  const Ray<TypeParam> ray = this->over(0, 0);
  EXPECT_FALSE(any(ray, PrintedParity::roots(ray, diamond)));
  this->expect_t(ray, diamond, 4);
}

}  // namespace
}  // namespace rayproof::polygon
