/// \file
/// Every ray/plane method on the special values of its arithmetic, named one by one.

#include <gtest/gtest.h>

#include <rayproof/plane/methods.hpp>
#include <vector>

namespace rayproof::plane {
namespace {

template <class T>
class EveryPlaneMethod : public testing::Test {
 protected:
  static constexpr T nan = not_a_number<T>;

  const Ray<T> ray_{{2, 3, -5}, {0, 0, 1}};
  /// The plane z = 1 in each form; what a form does not speak of is NaN, so that looking at it shows.
  const Plane<T> implicit_{PlaneForm::implicit, {nan, nan, nan}, {0, 0, 2}, -2,
                           {nan, nan, nan},     {nan, nan, nan}};
  const Plane<T> point_normal_{PlaneForm::point_normal, {7, 3, 1},      {0, 0, -4}, nan,
                               {nan, nan, nan},         {nan, nan, nan}};
  const Plane<T> parametric_{PlaneForm::parametric, {1, 1, 1}, {nan, nan, nan}, nan, {4, 0, 0}, {0, 2, 0}};
  const std::vector<Plane<T>> forms_{implicit_, point_normal_, parametric_};

  /// Runs `check(hit)` for each method whose formula is right, on the plane in each form.
  template <class Check>
  void for_each_right(const Ray<T>& ray, Check&& check) {
    for_each_method(forms_, [&]<class Method>(std::type_identity<Method>, const Plane<T>& plane) {
      if constexpr (!std::is_same_v<Method, PrintedImplicit>) check(Method::roots(ray, plane));
    });
  }

  void expect_miss(const Ray<T>& ray, const std::vector<Plane<T>>& planes) {
    for_each_method(planes, [&]<class Method>(std::type_identity<Method>, const Plane<T>& plane) {
      EXPECT_FALSE(any(ray, Method::roots(ray, plane)));
    });
  }

  template <class Visit>
  void for_each_method(const std::vector<Plane<T>>& planes, Visit&& visit) {
    for (const Plane<T>& plane : planes) {
      SCOPED_TRACE(static_cast<int>(plane.form));
      Topic::Methods::for_each([&]<class Method>(std::type_identity<Method> method) {
        SCOPED_TRACE(Method::name);
        visit(method, plane);
      });
    }
  }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(EveryPlaneMethod, Precisions);

TYPED_TEST(EveryPlaneMethod, MeetsThePlaneInEachOfItsForms) {
  this->for_each_right(this->ray_, [&](const FlatHit<TypeParam>& hit) {
    EXPECT_EQ(hit.discriminant, 0);
    EXPECT_EQ(hit.lo, 6);
    EXPECT_EQ(hit.hi, 6);
  });
}

TYPED_TEST(EveryPlaneMethod, MeetsThePlaneFromTheOtherSideToo) {
  const Ray<TypeParam> ray{{2, 3, 5}, {0, 0, -2}};
  this->for_each_right(ray, [&](const FlatHit<TypeParam>& hit) { EXPECT_EQ(nearest(ray, hit), 2); });
}

TYPED_TEST(EveryPlaneMethod, CountsAnOriginOnThePlane) {
  const Ray<TypeParam> ray{{2, 3, 1}, {1, 0, 1}};
  this->for_each_right(ray, [&](const FlatHit<TypeParam>& hit) { EXPECT_EQ(nearest(ray, hit), 0); });
}

TYPED_TEST(EveryPlaneMethod, CountsBothEndsOfTheInterval) {
  Ray<TypeParam> ray = this->ray_;
  ray.t_min = ray.t_max = 6;
  this->for_each_right(ray, [&](const FlatHit<TypeParam>& hit) { EXPECT_EQ(nearest(ray, hit), 6); });
}

TYPED_TEST(EveryPlaneMethod, TreatsMinusZeroAsZero) {
  Ray<TypeParam> ray = this->ray_;
  ray.origin.x = ray.direction.x = ray.direction.y = ray.t_min = TypeParam(-0.0);
  this->for_each_right(ray, [&](const FlatHit<TypeParam>& hit) { EXPECT_EQ(nearest(ray, hit), 6); });
}

TYPED_TEST(EveryPlaneMethod, MissesWhatLiesBehindTheOrigin) {
  Ray<TypeParam> ray = this->ray_;
  ray.origin.z = 3;
  this->for_each_right(ray, [&](const FlatHit<TypeParam>& hit) {
    EXPECT_EQ(hit.lo, -2);
    EXPECT_FALSE(any(ray, hit));
  });
}

TYPED_TEST(EveryPlaneMethod, MissesWhenParallelOrInThePlane) {
  Ray<TypeParam> ray = this->ray_;
  ray.direction = {3, -1, 0};
  this->expect_miss(ray, this->forms_);
  ray.origin.z = 1;
  this->expect_miss(ray, this->forms_);
  ray.direction.z = TypeParam(-0.0);
  this->expect_miss(ray, this->forms_);
}

TYPED_TEST(EveryPlaneMethod, MissesOnADirectionOfZero) {
  Ray<TypeParam> ray = this->ray_;
  ray.direction = {0, 0, 0};
  this->expect_miss(ray, this->forms_);
}

TYPED_TEST(EveryPlaneMethod, MissesAPlaneWithoutANormal) {
  std::vector<Plane<TypeParam>> planes = this->forms_;
  planes[0].normal = planes[1].normal = {0, 0, 0};
  planes[2].u = TypeParam(2) * planes[2].v;
  this->expect_miss(this->ray_, planes);
}

TYPED_TEST(EveryPlaneMethod, MissesOnNaNAnywhere) {
  for (int i = 0; i < 3; ++i) {
    SCOPED_TRACE(i);
    Ray<TypeParam> ray = this->ray_;
    ray.origin[i] = this->nan;
    this->expect_miss(ray, this->forms_);
    ray = this->ray_;
    ray.direction[i] = this->nan;
    this->expect_miss(ray, this->forms_);

    std::vector<Plane<TypeParam>> planes(6, this->parametric_);
    planes[0] = this->implicit_;
    planes[1] = planes[2] = this->point_normal_;
    planes[0].normal[i] = planes[1].normal[i] = planes[2].point[i] = this->nan;
    planes[3].point[i] = planes[4].u[i] = planes[5].v[i] = this->nan;
    this->expect_miss(this->ray_, planes);
  }
  Plane<TypeParam> plane = this->implicit_;
  plane.d = this->nan;
  this->expect_miss(this->ray_, {plane});
  Ray<TypeParam> ray = this->ray_;
  ray.t_min = this->nan;
  this->expect_miss(ray, this->forms_);
  ray = this->ray_;
  ray.t_max = this->nan;
  this->expect_miss(ray, this->forms_);
}

TYPED_TEST(EveryPlaneMethod, SpansAPlaneWhateverAxisItsNormalPointsAlong) {
  using T = TypeParam;
  for (const vec3<T>& n : {vec3<T>{2, 0, 0}, vec3<T>{0, -3, 0}, vec3<T>{0, 0, 1}, vec3<T>{1, -2, 4}}) {
    const Ray<T> ray{{1, 2, 3}, n};
    const Plane<T> plane{PlaneForm::point_normal, ray.origin + T(2) * n, n, 0, {}, {}};
    EXPECT_EQ(ByParameters::roots(ray, plane).lo, 2);
  }
}

TYPED_TEST(EveryPlaneMethod, GivesTheParametersOfAParametricPlane) {
  for (const FlatHit<TypeParam>& hit :
       {ByParameters::roots(this->ray_, this->parametric_), Rounded::roots(this->ray_, this->parametric_)}) {
    EXPECT_EQ(hit.u, TypeParam(0.25));
    EXPECT_EQ(hit.v, 1);
  }
  const FlatHit<TypeParam> without = ByParameters::roots(this->ray_, this->point_normal_);
  EXPECT_EQ(without.u, 0);
  EXPECT_EQ(without.v, 0);
}

TYPED_TEST(EveryPlaneMethod, RoundedComparesTheExactTWithTheEndOfTheInterval) {
  using T = TypeParam;
  Ray<T> ray{{0, 0, 0}, {0, 0, 3}};
  ray.t_max = T(1) / T(3);  // a little more than a third in float, a little less in double
  const bool is_reached = std::is_same_v<T, float>;
  const Plane<T> plane{PlaneForm::implicit, {}, {0, 0, 1}, -1, {}, {}};
  EXPECT_EQ(any(ray, Rounded::roots(ray, plane)), is_reached);
}

TYPED_TEST(EveryPlaneMethod, RoundedSeesARayThatLeavesAParallelByTheLastBit) {
  using T = TypeParam;
  const T e = std::numeric_limits<T>::epsilon();
  // (1 + e, 1, 0)·(1 - e, -1, 0) = -e², which no rounded sum of the products shows.
  const Plane<T> plane{PlaneForm::implicit, {}, {1 + e, 1, 0}, e * e, {}, {}};
  const Ray<T> ray{{0, 0, 0}, {1 - e, -1, 0}};
  EXPECT_EQ(Rounded::roots(ray, plane).lo, 1);
  EXPECT_FALSE(any(ray, ByEquation::roots(ray, plane)));
}

TYPED_TEST(EveryPlaneMethod, PrintedImplicitTakesCoefficientsForOne) {
  const FlatHit<TypeParam> hit = PrintedImplicit::roots(this->ray_, this->implicit_);
  EXPECT_EQ(hit.lo, 1);  // -(2 + 3 - 5 - 2) / 2
}

TYPED_TEST(EveryPlaneMethod, ATThatOverflowsIsNoHit) {
  using T = TypeParam;
  const T tiny = std::numeric_limits<T>::min(), huge = std::numeric_limits<T>::max() / 4;
  const Ray<T> ray{{0, 0, 0}, {0, 0, tiny}};
  const Plane<T> implicit{PlaneForm::implicit, {}, {0, 0, 1}, -huge, {}, {}};
  const Plane<T> level{PlaneForm::parametric, {0, 0, huge}, {}, 0, {1, 0, 0}, {0, 1, 0}};
  for (const FlatHit<T>& hit : {ByEquation::roots(ray, implicit), ByPointAndNormal::roots(ray, level),
                                ByParameters::roots(ray, level)}) {
    EXPECT_FALSE(any(ray, hit));
    EXPECT_LT(hit.discriminant, 0);
  }
}

}  // namespace
}  // namespace rayproof::plane
