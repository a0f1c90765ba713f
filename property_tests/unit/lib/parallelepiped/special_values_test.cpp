/// \file
/// Every ray/parallelepiped method on the special values of its arithmetic, named one by one.

#include <gtest/gtest.h>

#include <rayproof/parallelepiped/methods.hpp>

namespace rayproof::parallelepiped {
namespace {

template <class T>
class EveryParallelepipedMethod : public testing::Test {
 protected:
  static constexpr T nan = not_a_number<T>;
  static constexpr T inf = infinity<T>;

  using Edges = std::array<vec3<T>, 3>;
  /// Leaning along x: (2, 0, 0), (1, 1, 0) and (0, 0, 1) from the corner (0, 0, 0).
  const Parallelepiped<T> leaning_{{0, 0, 0}, Edges{vec3<T>{2, 0, 0}, vec3<T>{1, 1, 0}, vec3<T>{0, 0, 1}}};
  /// The same with an edge exchanged, so that the edges have the other handedness.
  const Parallelepiped<T> mirrored_{{0, 0, 0}, Edges{vec3<T>{1, 1, 0}, vec3<T>{2, 0, 0}, vec3<T>{0, 0, 1}}};
  const Ray<T> ray_{{-5, T(0.5), T(0.5)}, {1, 0, 0}};

  template <class Check>
  void for_each(const Ray<T>& ray, const Parallelepiped<T>& solid, Check&& check) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      SCOPED_TRACE(Method::name);
      check(Method::roots(ray, solid));
    });
  }

  /// Entry and exit, whichever way round the edges are named.
  void expect_chord(const Ray<T>& ray, T entry, T exit) {
    for (const auto& solid : {leaning_, mirrored_}) {
      for_each(ray, solid, [&](const Roots<T>& roots) {
        EXPECT_EQ(roots.lo, entry);
        EXPECT_EQ(roots.hi, exit);
        EXPECT_EQ(roots.discriminant > 0, entry < exit);
        EXPECT_EQ(roots.discriminant == 0, entry == exit);
      });
    }
  }

  void expect_no_roots(const Ray<T>& ray, const Parallelepiped<T>& solid) {
    for_each(ray, solid, [](const Roots<T>& roots) {
      EXPECT_EQ(roots.discriminant, -1);
      EXPECT_TRUE(std::isnan(roots.lo));
      EXPECT_TRUE(std::isnan(roots.hi));
    });
  }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(EveryParallelepipedMethod, Precisions);

TYPED_TEST(EveryParallelepipedMethod, MeetsTheLeaningFacesWhereTheyAre) {
  this->expect_chord(this->ray_, TypeParam(5.5), TypeParam(7.5));
}

TYPED_TEST(EveryParallelepipedMethod, MeetsTheSamePlacesFromBehind) {
  Ray<TypeParam> ray = this->ray_;
  ray.direction.x = -1;
  this->expect_chord(ray, TypeParam(-7.5), TypeParam(-5.5));
  this->for_each(ray, this->leaning_, [&](const auto& roots) { EXPECT_FALSE(any(ray, roots)); });
}

TYPED_TEST(EveryParallelepipedMethod, LeavesTheSolidFromInside) {
  Ray<TypeParam> ray = this->ray_;
  ray.origin.x = 1;
  this->expect_chord(ray, TypeParam(-0.5), TypeParam(1.5));
  this->for_each(ray, this->leaning_, [&](const auto& roots) { EXPECT_EQ(nearest(ray, roots), 1.5); });
}

TYPED_TEST(EveryParallelepipedMethod, CountsAnOriginOnAFaceAnEdgeAndACorner) {
  for (const vec3<TypeParam>& origin :
       {vec3<TypeParam>{TypeParam(0.5), TypeParam(0.5), TypeParam(0.5)},
        vec3<TypeParam>{TypeParam(0.5), TypeParam(0.5), 1}, vec3<TypeParam>{0, 0, 0}}) {
    const Ray<TypeParam> ray{origin, {1, 0, 0}};
    this->expect_chord(ray, 0, 2);
  }
}

TYPED_TEST(EveryParallelepipedMethod, CountsARayThatRunsInAFaceOrAlongAnEdge) {
  for (const TypeParam zero : {TypeParam(0.0), TypeParam(-0.0)}) {
    this->expect_chord({{-5, TypeParam(0.5), 1}, {1, zero, zero}}, TypeParam(5.5), TypeParam(7.5));
    this->expect_chord({{-5, 0, TypeParam(0.5)}, {1, zero, zero}}, 5, 7);
    this->expect_chord({{-5, 1, 1}, {1, zero, zero}}, 6, 8);
    this->expect_chord({{-1, -1, zero}, {1, 1, zero}}, 1, 2);  // along the leaning edge
  }
}

TYPED_TEST(EveryParallelepipedMethod, MissesJustBesideAFace) {
  Ray<TypeParam> ray = this->ray_;
  ray.origin.z = std::nextafter(TypeParam(1), TypeParam(2));
  this->expect_no_roots(ray, this->leaning_);
  ray.origin.z = -std::numeric_limits<TypeParam>::min();
  this->expect_no_roots(ray, this->leaning_);
}

TYPED_TEST(EveryParallelepipedMethod, TouchesAnEdgeAndACornerOnce) {
  this->expect_chord({{-1, 1, TypeParam(0.5)}, {1, -1, 0}}, 1, 1);            // the edge x = y = 0
  this->expect_chord({{-1, 1, 1}, {1, -1, -1}}, 1, 1);                        // the corner (0, 0, 0)
  this->expect_chord({{4, 0, TypeParam(0.5)}, {TypeParam(-1), 1, 0}}, 1, 1);  // the edge through (3, 1)
}

TYPED_TEST(EveryParallelepipedMethod, PassesThroughOppositeCorners) {
  this->expect_chord({{-3, -1, -1}, {3, 1, 1}}, 1, 2);
}

TYPED_TEST(EveryParallelepipedMethod, TakesMinusZeroForZero) {
  Ray<TypeParam> ray = this->ray_;
  ray.direction.y = ray.direction.z = ray.t_min = TypeParam(-0.0);
  Parallelepiped<TypeParam> solid = this->leaning_;
  solid.corner = {TypeParam(-0.0), TypeParam(-0.0), TypeParam(-0.0)};
  solid.edges[0].y = solid.edges[1].z = solid.edges[2].x = TypeParam(-0.0);
  this->for_each(ray, solid, [](const auto& roots) {
    EXPECT_EQ(roots.lo, 5.5);
    EXPECT_EQ(roots.hi, 7.5);
  });
}

TYPED_TEST(EveryParallelepipedMethod, MissesOnNaNAnywhere) {
  for (int i = 0; i < 18; ++i) {
    for (const vec3<TypeParam>& direction : {vec3<TypeParam>{1, 0, 0}, vec3<TypeParam>{1, 8, 1}}) {
      SCOPED_TRACE(i);
      Ray<TypeParam> ray{{1, TypeParam(0.5), TypeParam(0.5)}, direction};
      Parallelepiped<TypeParam> solid = this->leaning_;
      const std::array<vec3<TypeParam>*, 6> places{&ray.origin,     &ray.direction,  &solid.corner,
                                                   &solid.edges[0], &solid.edges[1], &solid.edges[2]};
      (*places[static_cast<std::size_t>(i / 3)])[i % 3] = this->nan;
      this->expect_no_roots(ray, solid);
    }
  }
  Ray<TypeParam> ray = this->ray_;
  ray.t_max = this->nan;
  this->for_each(ray, this->leaning_, [&](const auto& roots) { EXPECT_FALSE(any(ray, roots)); });
}

TYPED_TEST(EveryParallelepipedMethod, MissesOnADirectionOfZeroAndAnInfiniteOrigin) {
  Ray<TypeParam> ray{{1, TypeParam(0.5), TypeParam(0.5)}, {0, 0, 0}};
  this->expect_no_roots(ray, this->leaning_);
  ray = this->ray_;
  ray.origin.x = -this->inf;
  this->expect_no_roots(ray, this->leaning_);
}

TYPED_TEST(EveryParallelepipedMethod, MissesWithAnEmptyInterval) {
  Ray<TypeParam> ray = this->ray_;
  ray.t_min = 7;
  ray.t_max = 6;
  this->for_each(ray, this->leaning_, [&](const auto& roots) { EXPECT_FALSE(any(ray, roots)); });
}

}  // namespace
}  // namespace rayproof::parallelepiped
