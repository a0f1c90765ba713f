/// \file
/// Every ray/sphere method on the special values of its arithmetic, named one by one. What they have in
/// common is the contract table of docs/conventions.md.

#include <gtest/gtest.h>

#include <rayproof/sphere/methods.hpp>

namespace rayproof::sphere {
namespace {

template <class T>
class EverySphereMethod : public testing::Test {
 protected:
  static constexpr T nan = not_a_number<T>;
  static constexpr T inf = infinity<T>;
  static constexpr T smallest = std::numeric_limits<T>::denorm_min();
  static constexpr T largest = std::numeric_limits<T>::max();

  const Ray<T> ray_{{0, 0, -5}, {0, 0, 1}};
  const Sphere<T> sphere_{{0, 0, 0}, 1};

  /// Runs `check(roots)` for each method that is right on directions of length 1 (the one with 2ac is not).
  template <class Check>
  void for_each_right(const Ray<T>& ray, const Sphere<T>& sphere, Check&& check) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      SCOPED_TRACE(Method::name);
      if constexpr (!std::is_same_v<Method, Printed2ac>) check(Method::roots(ray, sphere));
    });
  }

  void expect_miss(const Ray<T>& ray, const Sphere<T>& sphere) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      SCOPED_TRACE(Method::name);
      const Roots<T> roots = Method::roots(ray, sphere);
      EXPECT_FALSE(any(ray, roots));
      EXPECT_EQ(nearest(ray, roots), inf);
    });
  }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(EverySphereMethod, Precisions);

TYPED_TEST(EverySphereMethod, MeetsTheUnitSphereAtFourAndSix) {
  this->for_each_right(this->ray_, this->sphere_, [&](const Roots<TypeParam>& roots) {
    EXPECT_EQ(roots.lo, 4);
    EXPECT_EQ(roots.hi, 6);
    EXPECT_EQ(nearest(this->ray_, roots), 4);
    EXPECT_TRUE(any(this->ray_, roots));
  });
}

TYPED_TEST(EverySphereMethod, TouchesATangentOnce) {
  Ray<TypeParam> ray = this->ray_;
  ray.origin.y = 1;
  this->for_each_right(ray, this->sphere_, [](const Roots<TypeParam>& roots) {
    EXPECT_EQ(roots.discriminant, 0);
    EXPECT_EQ(roots.lo, 5);
    EXPECT_EQ(roots.hi, 5);
  });
}

TYPED_TEST(EverySphereMethod, CountsAnOriginOnTheSurface) {
  Ray<TypeParam> ray = this->ray_;
  ray.origin.z = -1;
  this->for_each_right(ray, this->sphere_,
                       [&](const Roots<TypeParam>& roots) { EXPECT_EQ(nearest(ray, roots), 0); });
}

TYPED_TEST(EverySphereMethod, LeavesTheSphereFromInside) {
  Ray<TypeParam> ray = this->ray_;
  ray.origin.z = 0;
  this->for_each_right(ray, this->sphere_,
                       [&](const Roots<TypeParam>& roots) { EXPECT_EQ(nearest(ray, roots), 1); });
}

TYPED_TEST(EverySphereMethod, CountsBothEndsOfTheInterval) {
  Ray<TypeParam> ray = this->ray_;
  ray.t_min = 4;
  ray.t_max = 4;
  this->for_each_right(ray, this->sphere_,
                       [&](const Roots<TypeParam>& roots) { EXPECT_EQ(nearest(ray, roots), 4); });
}

TYPED_TEST(EverySphereMethod, MissesWhatLiesBehindTheOrigin) {
  Ray<TypeParam> ray = this->ray_;
  ray.direction.z = -1;
  this->expect_miss(ray, this->sphere_);
}

TYPED_TEST(EverySphereMethod, TreatsMinusZeroAsZero) {
  Ray<TypeParam> ray = this->ray_;
  ray.origin.x = ray.direction.x = ray.direction.y = ray.t_min = TypeParam(-0.0);
  this->for_each_right(ray, this->sphere_,
                       [&](const Roots<TypeParam>& roots) { EXPECT_EQ(nearest(ray, roots), 4); });
}

TYPED_TEST(EverySphereMethod, MissesOnNaNAnywhere) {
  for (int i = 0; i < 9; ++i) {
    SCOPED_TRACE(i);
    Ray<TypeParam> ray = this->ray_;
    Sphere<TypeParam> sphere = this->sphere_;
    if (i < 3) ray.origin[i] = this->nan;
    if (i >= 3 && i < 6) ray.direction[i - 3] = this->nan;
    if (i >= 6) sphere.center[i - 6] = this->nan;
    this->expect_miss(ray, sphere);
  }
  this->expect_miss(this->ray_, {{0, 0, 0}, this->nan});
  Ray<TypeParam> ray = this->ray_;
  ray.t_min = this->nan;
  this->expect_miss(ray, this->sphere_);
  ray = this->ray_;
  ray.t_max = this->nan;
  this->expect_miss(ray, this->sphere_);
}

TYPED_TEST(EverySphereMethod, MissesOnADirectionOfZero) {
  Ray<TypeParam> ray = this->ray_;
  ray.direction = {0, 0, 0};
  Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
    SCOPED_TRACE(Method::name);
    // As printed, the half-b form does not look at the direction's length and so can't notice.
    if constexpr (!std::is_same_v<Method, PrintedHalfB>) {
      EXPECT_FALSE(any(ray, Method::roots(ray, this->sphere_)));
    }
  });
}

TYPED_TEST(EverySphereMethod, MissesOnAnInfiniteOriginOrCentre) {
  Ray<TypeParam> ray = this->ray_;
  ray.origin.x = this->inf;
  this->expect_miss(ray, this->sphere_);
  this->expect_miss(this->ray_, {{this->inf, 0, 0}, 1});
}

TYPED_TEST(EverySphereMethod, MissesWithAnEmptyInterval) {
  Ray<TypeParam> ray = this->ray_;
  ray.t_min = 6;
  ray.t_max = 4;
  this->expect_miss(ray, this->sphere_);
}

TYPED_TEST(EverySphereMethod, MeetsARadiusOfZeroInAPoint) {
  const Sphere<TypeParam> point{{0, 0, 0}, 0};
  this->for_each_right(this->ray_, point,
                       [&](const Roots<TypeParam>& roots) { EXPECT_EQ(nearest(this->ray_, roots), 5); });
}

TEST(StableSphere, LosesNoDigitsOfTheRootNearZeroOnceItHasTheCoefficients) {
  for (int i = 1; i < 50; ++i) {
    const Ray<float> ray{{0, 0.1F, -1 - 1e-6F * static_cast<float>(i)}, {0.01F, 0, 1}};
    const Sphere<float> sphere{{0, 0, 0}, 1.005F};
    const auto [a, half_b, c] = coefficients(ray, sphere);
    const double b = -half_b, q = b + std::sqrt(b * b - double{a} * c);
    EXPECT_NEAR(Stable::roots(ray, sphere).lo * q / c, 1, 4 * std::numeric_limits<float>::epsilon());
    EXPECT_GT(std::abs(HalfB::roots(ray, sphere).lo * q / c - 1), 1e-6) << "it ought to lose them";
  }
}

}  // namespace
}  // namespace rayproof::sphere
