/// \file
/// Every ray/box method on the special values of its arithmetic, named one by one.

#include <gtest/gtest.h>

#include <rayproof/box/methods.hpp>

namespace rayproof::box {
namespace {

template <class T>
class EveryBoxMethod : public testing::Test {
 protected:
  static constexpr T nan = not_a_number<T>;
  static constexpr T inf = infinity<T>;

  const Ray<T> ray_{{T(0.5), T(0.5), -5}, {0, 0, 1}};
  const Box<T> box_{{0, 0, 0}, {1, 1, 1}};

  /// Whether a method has the exits that the others have; Padded moves them on purpose.
  template <class Method>
  static constexpr bool is_exact_in_small_numbers = !std::is_same_v<Method, Padded>;

  /// Runs `check(roots)` for each method but the printed one.
  template <class Check>
  void for_each_right(const Ray<T>& ray, const Box<T>& box, Check&& check) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      SCOPED_TRACE(Method::name);
      if constexpr (!std::is_same_v<Method, PrintedSlabs>) check(Method::roots(ray, box));
    });
  }

  /// Entry and exit in every method but the printed one; the padded exit lies two ulps later.
  void expect_chord(const Ray<T>& ray, const Box<T>& box, T entry, T exit) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      SCOPED_TRACE(Method::name);
      if constexpr (!std::is_same_v<Method, PrintedSlabs>) {
        const Roots<T> roots = Method::roots(ray, box);
        EXPECT_EQ(roots.lo, entry);
        if constexpr (is_exact_in_small_numbers<Method>) {
          EXPECT_EQ(roots.hi, exit);
          EXPECT_EQ(roots.discriminant > 0, entry < exit);
          EXPECT_EQ(roots.discriminant == 0, entry == exit);
        } else {
          EXPECT_EQ(roots.hi, exit + 2 * std::numeric_limits<T>::epsilon() * std::abs(exit));
        }
      }
    });
  }

  void expect_miss(const Ray<T>& ray, const Box<T>& box) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      SCOPED_TRACE(Method::name);
      const Roots<T> roots = Method::roots(ray, box);
      EXPECT_FALSE(any(ray, roots));
      EXPECT_EQ(nearest(ray, roots), inf);
    });
  }

  /// No point of the whole line is a hit.
  void expect_no_roots(const Ray<T>& ray, const Box<T>& box) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      SCOPED_TRACE(Method::name);
      const Roots<T> roots = Method::roots(ray, box);
      EXPECT_EQ(roots.discriminant, -1);
      EXPECT_TRUE(std::isnan(roots.lo));
      EXPECT_TRUE(std::isnan(roots.hi));
    });
  }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(EveryBoxMethod, Precisions);

TYPED_TEST(EveryBoxMethod, MeetsTheUnitBoxAtFiveAndSix) { this->expect_chord(this->ray_, this->box_, 5, 6); }

TYPED_TEST(EveryBoxMethod, MeetsTheSamePlacesFromBehind) {
  Ray<TypeParam> ray = this->ray_;
  ray.direction.z = -1;
  this->expect_chord(ray, this->box_, -6, -5);
  this->expect_miss(ray, this->box_);
}

TYPED_TEST(EveryBoxMethod, LeavesTheBoxFromInside) {
  Ray<TypeParam> ray = this->ray_;
  ray.origin.z = TypeParam(0.5);
  this->expect_chord(ray, this->box_, TypeParam(-0.5), TypeParam(0.5));
  this->for_each_right(ray, this->box_,
                       [&](const auto& roots) { EXPECT_NEAR(nearest(ray, roots), 0.5, 1e-6); });
}

TYPED_TEST(EveryBoxMethod, CountsAnOriginOnAFace) {
  Ray<TypeParam> ray = this->ray_;
  ray.origin.z = 0;
  this->for_each_right(ray, this->box_, [&](const auto& roots) { EXPECT_EQ(nearest(ray, roots), 0); });
  ray.origin.z = 1;
  this->for_each_right(ray, this->box_, [&](const auto& roots) { EXPECT_EQ(nearest(ray, roots), 0); });
}

TYPED_TEST(EveryBoxMethod, CountsARayThatRunsInAFaceOrAlongAnEdge) {
  for (const TypeParam x : {TypeParam(0), TypeParam(1)}) {
    for (const TypeParam zero : {TypeParam(0.0), TypeParam(-0.0)}) {
      Ray<TypeParam> ray = this->ray_;
      ray.origin.x = x;
      ray.direction.x = zero;
      this->expect_chord(ray, this->box_, 5, 6);
      ray.origin.y = 1 - x;
      ray.direction.y = zero;
      this->expect_chord(ray, this->box_, 5, 6);
    }
  }
}

TYPED_TEST(EveryBoxMethod, MissesJustBesideAFace) {
  for (const TypeParam zero : {TypeParam(0.0), TypeParam(-0.0)}) {
    Ray<TypeParam> ray = this->ray_;
    ray.direction.x = zero;
    ray.origin.x = std::nextafter(TypeParam(1), TypeParam(2));
    this->expect_no_roots(ray, this->box_);
    ray.origin.x = -std::numeric_limits<TypeParam>::denorm_min();
    this->expect_no_roots(ray, this->box_);
  }
}

TYPED_TEST(EveryBoxMethod, TouchesAnEdgeOnce) {
  const Ray<TypeParam> ray{{-1, 0, TypeParam(0.5)}, {1, 1, 0}};  // through x = 0, y = 1
  this->expect_chord(ray, this->box_, 1, 1);
}

TYPED_TEST(EveryBoxMethod, TouchesACornerOnce) {
  const Ray<TypeParam> ray{{-2, 0, 2}, {2, 1, -1}};  // through (0, 1, 1)
  this->expect_chord(ray, this->box_, 1, 1);
}

TYPED_TEST(EveryBoxMethod, PassesThroughOppositeCorners) {
  const Ray<TypeParam> ray{{-1, -1, -1}, {1, 1, 1}};
  this->expect_chord(ray, this->box_, 1, 2);
}

TYPED_TEST(EveryBoxMethod, MeetsAFlatBoxOnceAndARayInItTwice) {
  Box<TypeParam> flat = this->box_;
  flat.max.z = 0;
  this->expect_chord(this->ray_, flat, 5, 5);
  const Ray<TypeParam> inside{{-1, TypeParam(0.5), 0}, {1, 0, 0}};
  this->expect_chord(inside, flat, 1, 2);
}

TYPED_TEST(EveryBoxMethod, MeetsABoxThatIsAPoint) {
  const Box<TypeParam> point{{1, 2, 3}, {1, 2, 3}};
  const Ray<TypeParam> ray{{-1, 0, 1}, {1, 1, 1}};
  this->expect_chord(ray, point, 2, 2);
}

TYPED_TEST(EveryBoxMethod, TakesMinusZeroForZero) {
  Ray<TypeParam> ray = this->ray_;
  Box<TypeParam> box = this->box_;
  box.min = {TypeParam(-0.0), TypeParam(-0.0), TypeParam(-0.0)};
  ray.origin.x = ray.direction.x = ray.direction.y = ray.t_min = TypeParam(-0.0);
  this->expect_chord(ray, box, 5, 6);
}

TYPED_TEST(EveryBoxMethod, MissesOnNaNAnywhere) {
  for (int i = 0; i < 12; ++i) {
    for (const vec3<TypeParam>& direction :
         {vec3<TypeParam>{0, 0, 1}, vec3<TypeParam>{1, 1, 8}, vec3<TypeParam>{-1, -1, 8}}) {
      SCOPED_TRACE(i);
      Ray<TypeParam> ray{{TypeParam(0.5), TypeParam(0.5), TypeParam(0.5)}, direction};
      Box<TypeParam> box = this->box_;
      (i < 3 ? ray.origin : i < 6 ? ray.direction : i < 9 ? box.min : box.max)[i % 3] = this->nan;
      this->expect_no_roots(ray, box);
    }
  }
  Ray<TypeParam> ray = this->ray_;
  ray.t_min = this->nan;
  this->expect_miss(ray, this->box_);
  ray = this->ray_;
  ray.t_max = this->nan;
  this->expect_miss(ray, this->box_);
}

TYPED_TEST(EveryBoxMethod, MissesOnADirectionOfZero) {
  for (const TypeParam z : {TypeParam(0.5), TypeParam(1), TypeParam(2)}) {
    const Ray<TypeParam> ray{{TypeParam(0.5), TypeParam(0.5), z}, {0, TypeParam(-0.0), 0}};
    this->expect_no_roots(ray, this->box_);
  }
}

TYPED_TEST(EveryBoxMethod, MissesOnAnInfiniteOrigin) {
  Ray<TypeParam> ray = this->ray_;
  for (const TypeParam end : {this->inf, -this->inf}) {
    ray.origin.z = end;
    this->expect_no_roots(ray, this->box_);
  }
}

TYPED_TEST(EveryBoxMethod, MissesWithAnEmptyIntervalAndABoxTurnedInsideOut) {
  Ray<TypeParam> ray = this->ray_;
  ray.t_min = 6;
  ray.t_max = 5;
  this->expect_miss(ray, this->box_);
  Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
    SCOPED_TRACE(Method::name);
    if constexpr (!std::is_same_v<Method, PrintedSlabs>) {  // which puts the planes in order again
      EXPECT_EQ(Method::roots(this->ray_, Box<TypeParam>{{0, 0, 1}, {1, 1, 0}}).discriminant, -1);
    }
  });
}

TYPED_TEST(EveryBoxMethod, AsPrintedLosesARayInAFace) {
  Ray<TypeParam> ray = this->ray_;
  EXPECT_EQ(PrintedSlabs::roots(ray, this->box_).lo, 5);
  ray.origin.x = 0;
  EXPECT_TRUE(std::isnan(PrintedSlabs::roots(ray, this->box_).lo));
}

}  // namespace
}  // namespace rayproof::box
