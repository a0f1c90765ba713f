/// \file
/// Every ray/cylinder method on the special values of its arithmetic, named one by one. Where the printed one
/// is asked too, t lies in [0, 1].

#include <gtest/gtest.h>

#include <rayproof/cylinder/methods.hpp>

namespace rayproof::cylinder {
namespace {

template <class T>
class EveryCylinderMethod : public testing::Test {
 protected:
  static constexpr T nan = not_a_number<T>;
  static constexpr T inf = infinity<T>;

  const Cylinder<T> open_{2, 1, 4, false};
  const Cylinder<T> capped_{2, 1, 4, true};
  const Ray<T> ray_{{-6, 0, 1}, {1, 0, 0}};

  template <class Check>
  void for_each_right(const Ray<T>& ray, const Cylinder<T>& cylinder, Check&& check) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      SCOPED_TRACE(Method::name);
      if constexpr (!std::is_same_v<Method, Printed>) check(Method::roots(ray, cylinder));
    });
  }

  void expect_two(const Ray<T>& ray, const Cylinder<T>& cylinder, T lo, T hi) {
    for_each_right(ray, cylinder, [&](const Roots<T>& roots) {
      EXPECT_EQ(roots.lo, lo);
      EXPECT_EQ(roots.hi, hi);
      EXPECT_GT(roots.discriminant, 0);
    });
  }

  /// One hit that is no tangent: the lower root is none.
  void expect_one(const Ray<T>& ray, const Cylinder<T>& cylinder, T t) {
    for_each_right(ray, cylinder, [&](const Roots<T>& roots) {
      EXPECT_TRUE(std::isnan(roots.lo));
      EXPECT_EQ(roots.hi, t);
      EXPECT_GT(roots.discriminant, 0);
    });
  }

  void expect_tangent(const Ray<T>& ray, const Cylinder<T>& cylinder, T t) {
    for_each_right(ray, cylinder, [&](const Roots<T>& roots) {
      EXPECT_EQ(roots.lo, t);
      EXPECT_EQ(roots.hi, t);
      EXPECT_EQ(roots.discriminant, 0);
    });
  }

  void expect_no_roots(const Ray<T>& ray, const Cylinder<T>& cylinder) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      SCOPED_TRACE(Method::name);
      const Roots<T> roots = Method::roots(ray, cylinder);
      EXPECT_EQ(roots.discriminant, -1);
      EXPECT_TRUE(std::isnan(roots.lo));
      EXPECT_TRUE(std::isnan(roots.hi));
    });
  }

  void expect_miss(const Ray<T>& ray, const Cylinder<T>& cylinder) {
    for_each_right(ray, cylinder, [&](const Roots<T>& roots) {
      EXPECT_FALSE(any(ray, roots));
      EXPECT_EQ(nearest(ray, roots), inf);
    });
  }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(EveryCylinderMethod, Precisions);

TYPED_TEST(EveryCylinderMethod, MeetsTheSideAtFourAndEight) {
  this->expect_two(this->ray_, this->open_, 4, 8);
  this->expect_two(this->ray_, this->capped_, 4, 8);
}

TYPED_TEST(EveryCylinderMethod, LeavesTheSideFromInsideAndMissesItFromBehind) {
  Ray<TypeParam> ray = this->ray_;
  ray.origin.x = 0;
  this->expect_two(ray, this->open_, -2, 2);
  this->for_each_right(ray, this->open_, [&](const auto& roots) { EXPECT_EQ(nearest(ray, roots), 2); });
  ray.origin.x = 6;
  this->expect_miss(ray, this->open_);
  this->expect_miss(ray, this->capped_);
}

TYPED_TEST(EveryCylinderMethod, TouchesTheSideOnceWhereTheRayIsTangent) {
  Ray<TypeParam> ray = this->ray_;
  for (const int side : {-1, 1}) {
    ray.origin.y = TypeParam(side);
    this->expect_tangent(ray, this->open_, 6);
    this->expect_tangent(ray, this->capped_, 6);
  }
  ray.direction.z = 1;
  ray.origin.z = -2;  // reaches the side just at the upper rim
  this->expect_tangent(ray, this->open_, 6);
  this->expect_tangent(ray, this->capped_, 6);
  ray.origin.z = TypeParam(-1.5);  // and just above it
  this->expect_no_roots(ray, this->open_);
  this->expect_no_roots(ray, this->capped_);
}

TYPED_TEST(EveryCylinderMethod, EntersTheOpenCylinderThroughItsEndAndTheCappedOneThroughItsCap) {
  const Ray<TypeParam> up{{0, 0, -1}, {1, 0, 1}};
  this->expect_one(up, this->open_, 2);
  this->expect_two(up, this->capped_, 1, 2);
  const Ray<TypeParam> down{{0, 0, 5}, {1, 0, -1}};
  this->expect_one(down, this->open_, 2);
  this->expect_two(down, this->capped_, 1, 2);
}

TYPED_TEST(EveryCylinderMethod, PassesThroughBothEndsOfTheOpenCylinderUnharmed) {
  const Ray<TypeParam> ray{{0, 0, -4}, {TypeParam(0.125), 0, 4}};
  this->expect_no_roots(ray, this->open_);
  this->expect_two(ray, this->capped_, 1, 2);
}

TYPED_TEST(EveryCylinderMethod, CountsTheRims) {
  for (const TypeParam z : {TypeParam(0), TypeParam(4)}) {  // inside the plane of a cap
    for (const TypeParam zero : {TypeParam(0.0), TypeParam(-0.0)}) {
      const Ray<TypeParam> ray{{-6, 0, z}, {1, 0, zero}};
      this->expect_two(ray, this->open_, 4, 8);
      this->expect_two(ray, this->capped_, 4, 8);
    }
  }
  const Ray<TypeParam> diagonal{{-4, 0, -2}, {2, 0, 2}};  // from rim to rim
  this->expect_two(diagonal, this->open_, 1, 3);
  this->expect_two(diagonal, this->capped_, 1, 3);
  const Ray<TypeParam> outside{{-3, 0, -1}, {1, 0, -1}};  // away from the cylinder
  this->expect_no_roots(outside, this->capped_);
  const Ray<TypeParam> touching{{-3, 0, 1}, {1, 0, -1}};  // meets the lower rim from outside
  this->expect_one(touching, this->open_, 1);
  this->expect_one(touching, this->capped_, 1);
}

TYPED_TEST(EveryCylinderMethod, MissesJustBeyondTheEnds) {
  Ray<TypeParam> ray = this->ray_;
  for (const TypeParam z :
       {-std::numeric_limits<TypeParam>::denorm_min(), std::nextafter(TypeParam(4), TypeParam(5))}) {
    ray.origin.z = z;
    this->expect_no_roots(ray, this->open_);
    this->expect_no_roots(ray, this->capped_);
  }
}

TYPED_TEST(EveryCylinderMethod, AlongTheAxisMeetsOnlyCapsFromInsideAndFromOnTheSide) {
  for (const TypeParam zero : {TypeParam(0.0), TypeParam(-0.0)}) {
    for (const TypeParam x : {TypeParam(0), TypeParam(1), TypeParam(2)}) {
      const Ray<TypeParam> up{{x, 0, -1}, {zero, zero, 1}};
      this->expect_no_roots(up, this->open_);
      this->expect_two(up, this->capped_, 1, 5);
      const Ray<TypeParam> down{{0, x / 2, 5}, {zero, zero, TypeParam(-0.5)}};
      this->expect_no_roots(down, this->open_);
      this->expect_two(down, this->capped_, 2, 10);
    }
    const Ray<TypeParam> beside{{std::nextafter(TypeParam(2), TypeParam(3)), 0, -1}, {zero, zero, 1}};
    this->for_each_right(beside, this->open_, [&](const auto& roots) { EXPECT_FALSE(any(beside, roots)); });
    EXPECT_EQ(Rounded::roots(beside, this->capped_).discriminant, -1);
    const Ray<TypeParam> outside{{3, 0, -1}, {zero, zero, 1}};
    this->expect_no_roots(outside, this->open_);
    this->expect_no_roots(outside, this->capped_);
  }
}

TYPED_TEST(EveryCylinderMethod, AHeightOfZeroIsAnEllipseOrADisk) {
  const Cylinder<TypeParam> ellipse{2, 1, 0, false};
  const Cylinder<TypeParam> disk{2, 1, 0, true};
  const Ray<TypeParam> through{{0, 0, -1}, {TypeParam(0.5), 0, 1}};
  this->expect_no_roots(through, ellipse);
  this->expect_one(through, disk, 1);
  this->expect_one({{1, 0, -1}, {0, 0, 1}}, disk, 1);
  this->expect_one({{1, 0, -1}, {1, 0, 1}}, ellipse, 1);
  this->expect_one({{1, 0, -1}, {1, 0, 1}}, disk, 1);
  this->expect_one({{2, 0, -1}, {0, 0, 1}}, ellipse, 1);
  this->expect_one({{0, -1, 3}, {0, 0, -1}}, ellipse, 3);
  this->expect_no_roots({{0, 0, -1}, {0, 0, 1}}, ellipse);
  this->expect_no_roots({{2, 0, 0}, {0, 0, 0}}, ellipse);
  this->expect_two({{-6, 0, 0}, {1, 0, 0}}, ellipse, 4, 8);
  this->expect_two({{-6, 0, 0}, {1, 0, 0}}, disk, 4, 8);
}

TYPED_TEST(EveryCylinderMethod, TakesMinusZeroForZero) {
  Ray<TypeParam> ray = this->ray_;
  ray.origin.y = ray.origin.z = ray.direction.y = ray.direction.z = ray.t_min = TypeParam(-0.0);
  this->expect_two(ray, this->open_, 4, 8);
  this->expect_two(ray, this->capped_, 4, 8);
}

TYPED_TEST(EveryCylinderMethod, MissesOnNaNAnywhere) {
  for (const vec3<TypeParam>& direction :
       {vec3<TypeParam>{8, 0, 0}, vec3<TypeParam>{0, 0, 8}, vec3<TypeParam>{8, 2, 1}}) {
    for (int i = 0; i < 18; ++i) {
      SCOPED_TRACE(i);
      Ray<TypeParam> ray{{0, 0, 1}, direction};
      Cylinder<TypeParam> cylinder = i % 2 == 0 ? this->open_ : this->capped_;
      const std::array<TypeParam*, 9> places{&ray.origin.x,    &ray.origin.y,    &ray.origin.z,
                                             &ray.direction.x, &ray.direction.y, &ray.direction.z,
                                             &cylinder.rx,     &cylinder.ry,     &cylinder.height};
      *places[static_cast<std::size_t>(i / 2)] = this->nan;
      this->expect_no_roots(ray, cylinder);
    }
  }
  Ray<TypeParam> ray = this->ray_;
  ray.t_max = this->nan;
  this->expect_miss(ray, this->capped_);
}

TYPED_TEST(EveryCylinderMethod, MissesOnADirectionOfZeroAndAnInfiniteOrigin) {
  for (const auto& cylinder : {this->open_, this->capped_}) {
    for (const TypeParam x : {TypeParam(0), TypeParam(2), TypeParam(3)}) {
      this->expect_no_roots({{x, 0, 1}, {0, 0, 0}}, cylinder);
    }
    for (const TypeParam end : {this->inf, -this->inf}) {
      this->expect_no_roots({{end, 0, 1}, {1, 0, 0}}, cylinder);
      this->expect_no_roots({{0, 0, end}, {1, 0, 1}}, cylinder);
      this->expect_no_roots({{0, 0, end}, {0, 0, 1}}, cylinder);
    }
  }
}

TYPED_TEST(EveryCylinderMethod, MissesWithAnEmptyInterval) {
  Ray<TypeParam> ray = this->ray_;
  ray.t_min = 8;
  ray.t_max = 4;
  this->expect_miss(ray, this->open_);
}

TYPED_TEST(EveryCylinderMethod, AsPrintedSeesNothingBeyondTheDirectionsTipAndNoCap) {
  EXPECT_EQ(Printed::roots(this->ray_, this->open_).discriminant, -1);
  Ray<TypeParam> ray = this->ray_;
  ray.direction.x = 8;
  EXPECT_EQ(Printed::roots(ray, this->open_).lo, TypeParam(0.5));
  EXPECT_EQ(Printed::roots(ray, this->open_).hi, 1);
  const Ray<TypeParam> up{{0, 0, -1}, {0, 0, 2}};
  EXPECT_EQ(Printed::roots(up, this->capped_).discriminant, -1);
}

}  // namespace
}  // namespace rayproof::cylinder
