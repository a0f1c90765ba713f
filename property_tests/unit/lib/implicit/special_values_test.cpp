/// \file
/// Rays and surfaces f = 0 whose roots are known beforehand, by name.

#include <gtest/gtest.h>

#include <rayproof/implicit/quadric.hpp>
#include <rayproof/implicit/roots.hpp>
#include <rayproof/implicit/torus.hpp>

namespace rayproof::implicit {
namespace {

template <class T>
class EnclosedRootsOf : public testing::Test {
 protected:
  static constexpr T inf = infinity<T>;
  static constexpr T nan = not_a_number<T>;
  const Ray<T> ray_{{0, 0, -5}, {0, 0, 1}};
  const Quadric<T> sphere_{.xx = 1, .yy = 1, .zz = 1, .ww = -1};
  const Torus<T> torus_{2, 0.5};

  static void expect_none(const EnclosedRoots<T>& found) { EXPECT_TRUE(found.empty()); }

  /// Enclosures of one status, one around each of the values, none wider than `width(value)`.
  template <class Width>
  static void expect_enclosed(const EnclosedRoots<T>& found, RootStatus status, const std::vector<T>& values,
                              Width&& width) {
    ASSERT_EQ(found.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_EQ(found[i].status, status);
      EXPECT_LE(found[i].lo, values[i]);
      EXPECT_GE(found[i].hi, values[i]);
      EXPECT_LE(found[i].hi - found[i].lo, width(values[i]));
    }
  }
  /// At most a few ulps wide.
  static void expect_certain(const EnclosedRoots<T>& found, const std::vector<T>& values) {
    expect_enclosed(found, RootStatus::certain, values,
                    [](T value) { return 8 * std::numeric_limits<T>::epsilon() * abs(value); });
  }
  static void expect_undecided(const EnclosedRoots<T>& found, const std::vector<T>& values) {
    expect_enclosed(found, RootStatus::undecided, values, [](T /*value*/) { return T(0.01); });
  }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(EnclosedRootsOf, Precisions);

TYPED_TEST(EnclosedRootsOf, CrossTheUnitSphereAtFourAndSix) {
  this->expect_certain(roots(this->ray_, this->sphere_), {4, 6});
}

TYPED_TEST(EnclosedRootsOf, CrossATorusFourTimes) {
  const Ray<TypeParam> ray{{-5, 0, 0}, {1, 0, 0}};
  this->expect_certain(roots(ray, this->torus_), {2.5, 3.5, 6.5, 7.5});
}

TYPED_TEST(EnclosedRootsOf, PassThroughTheHoleOfATorus) {
  this->expect_none(roots(this->ray_, this->torus_));
}

TYPED_TEST(EnclosedRootsOf, AreUndecidedAtTangents) {
  Ray<TypeParam> ray = this->ray_;
  ray.origin.y = 1;
  this->expect_undecided(roots(ray, this->sphere_), {5});
  const Ray<TypeParam> over{{-5, 0, 0.5}, {1, 0, 0}};
  this->expect_undecided(roots(over, this->torus_), {3, 7});
}

TYPED_TEST(EnclosedRootsOf, StartOnTheSurfaceAtExactlyZero) {
  Ray<TypeParam> ray = this->ray_;
  ray.origin.z = -1;
  for (const TypeParam t_min : {TypeParam(0), TypeParam(-0.0), TypeParam(-2), -this->inf}) {
    ray.t_min = t_min;
    const auto found = roots(ray, this->sphere_);
    this->expect_certain(found, {0, 2});
    EXPECT_EQ(found[0].lo, 0);
    EXPECT_EQ(found[0].hi, 0);
  }
}

TYPED_TEST(EnclosedRootsOf, CountBothEndsOfTheInterval) {
  Ray<TypeParam> ray = this->ray_;
  ray.t_min = 4;
  ray.t_max = 6;
  this->expect_certain(roots(ray, this->sphere_), {4, 6});
  ray.t_max = 4;
  this->expect_certain(roots(ray, this->sphere_), {4});
  ray.t_min = std::nextafter(TypeParam(4), TypeParam(5));
  ray.t_max = std::nextafter(TypeParam(6), TypeParam(5));
  this->expect_none(roots(ray, this->sphere_));
}

TYPED_TEST(EnclosedRootsOf, LookBehindOnAWholeLine) {
  const Ray<TypeParam> line{{0, 0, -5}, {0, 0, -1}, -this->inf, this->inf};
  this->expect_certain(roots(line, this->sphere_), {-6, -4});
}

TYPED_TEST(EnclosedRootsOf, HaveNoneForADirectionOfZero) {
  const Ray<TypeParam> still{{0, 0, -1}, {0, 0, 0}};
  this->expect_none(roots(still, this->sphere_));
}

TYPED_TEST(EnclosedRootsOf, HaveNoneForAnEmptyInterval) {
  Ray<TypeParam> ray = this->ray_;
  ray.t_min = 5;
  ray.t_max = 4;
  this->expect_none(roots(ray, this->sphere_));
}

TYPED_TEST(EnclosedRootsOf, HaveNoneForNaNAnywhere) {
  for (int i = 0; i < 8; ++i) {
    Ray<TypeParam> ray = this->ray_;
    TypeParam& spoilt = i < 3 ? ray.origin[i] : i < 6 ? ray.direction[i - 3] : i == 6 ? ray.t_min : ray.t_max;
    spoilt = this->nan;
    this->expect_none(roots(ray, this->sphere_));
    this->expect_none(roots(ray, this->torus_));
  }
  using Q = Quadric<TypeParam>;
  for (TypeParam Q::*const spoilt :
       {&Q::xx, &Q::yy, &Q::zz, &Q::yz, &Q::xz, &Q::xy, &Q::xw, &Q::yw, &Q::zw, &Q::ww}) {
    Q quadric = this->sphere_;
    quadric.*spoilt = this->nan;
    this->expect_none(roots(this->ray_, quadric));
  }
  this->expect_none(roots(Ray<TypeParam>{{-5, 0, 0}, {1, 0, 0}}, Torus<TypeParam>{2, this->nan}));
  this->expect_none(roots(Ray<TypeParam>{{-5, 0, 0}, {1, 0, 0}}, Torus<TypeParam>{this->nan, 0.5}));
}

TYPED_TEST(EnclosedRootsOf, HaveNoneForAnInfiniteRay) {
  for (int i = 0; i < 6; ++i) {
    Ray<TypeParam> ray = this->ray_;
    (i < 3 ? ray.origin[i] : ray.direction[i - 3]) = this->inf;
    this->expect_none(roots(ray, this->sphere_));
  }
}

TYPED_TEST(EnclosedRootsOf, AreEverywhereWhereAllTenCoefficientsAreZero) {
  const auto found = roots(this->ray_, Quadric<TypeParam>{});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].status, RootStatus::everywhere);
  EXPECT_EQ(found[0].lo, 0);
  EXPECT_EQ(found[0].hi, this->inf);
}

TYPED_TEST(EnclosedRootsOf, AreEverywhereInAPlaneTakenTwice) {
  const auto found = roots(this->ray_, Quadric<TypeParam>{.xx = 1});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].status, RootStatus::everywhere);
}

TYPED_TEST(EnclosedRootsOf, HaveNoneAlongACylinderAndOneAlongAnAsymptote) {
  const Ray<TypeParam> inside{{0, 0, 0}, {0, 0, 1}, -this->inf, this->inf};
  this->expect_none(roots(inside, Quadric<TypeParam>{.xx = 1, .yy = 1, .ww = -1}));
  const Ray<TypeParam> asymptote{{3, 1, -1}, {0, 3, 3}, -this->inf, this->inf};
  const Quadric<TypeParam> cone{.xx = 1, .yy = 1, .zz = -1};
  this->expect_certain(roots(asymptote, cone), {TypeParam(-0.75)});
}

TYPED_TEST(EnclosedRootsOf, OnlyTouchACircleAndADoubleSphere) {
  const Ray<TypeParam> ray{{-5, 0, 0}, {1, 0, 0}};
  this->expect_undecided(roots(ray, Torus<TypeParam>{2, 0}), {3, 7});
  this->expect_undecided(roots(ray, Torus<TypeParam>{0, 1}), {4, 6});
}

TYPED_TEST(EnclosedRootsOf, AreLeftUndecidedWhenTheBudgetIsSpent) {
  const auto spent = search(this->ray_, this->sphere_, 1).roots;
  ASSERT_FALSE(spent.empty());
  for (const auto& one : spent) EXPECT_EQ(one.status, RootStatus::undecided);
  for (const TypeParam root : {TypeParam(4), TypeParam(6)})
    EXPECT_TRUE(std::any_of(spent.begin(), spent.end(),
                            [&](const auto& one) { return one.lo <= root && root <= one.hi; }));
  const Ray<TypeParam> ruling{{1, 0, 0}, {0, 1, 1}};
  const auto endless = search(ruling, Quadric<TypeParam>{.xx = 1, .yy = 1, .zz = -1, .ww = -1});
  EXPECT_GE(endless.evaluations, default_budget);
  EXPECT_LE(static_cast<double>(endless.evaluations),
            2.0 * default_budget + search_contract.overrun.promised);
  for (const auto& one : endless.roots) EXPECT_EQ(one.status, RootStatus::undecided);
}

TYPED_TEST(EnclosedRootsOf, ShareOneUndecidedEnclosureBeyondTheGreatestNumber) {
  const TypeParam slow = sizeof(TypeParam) == 4 ? TypeParam(0x1p-100) : TypeParam(0x1p-1000);
  const Ray<TypeParam> ray{{0, 0, 0}, {0, 0, slow}};
  const Quadric<TypeParam> planes{.zz = 1, .zw = -(0x1p+33F + 0x1p+40F), .ww = 0x1p+73F};
  const auto found = roots(ray, planes);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].status, RootStatus::undecided);
  EXPECT_EQ(found[0].hi, this->inf);
}

/// A surface of one's own, with a root and no homogeneous form: a hill over the plane.
struct Hill {
  template <class T>
  T operator()(const T& x, const T& y, const T& z) const {
    return z - T(1) / sqrt(T(1) + square(x) + square(y));
  }
};

TYPED_TEST(EnclosedRootsOf, TakeAnyFormulaOfTheArithmetic) {
  const Ray<TypeParam> down{{0, 0, 5}, {0, 0, -1}};
  this->expect_certain(roots(down, Hill{}), {4});
  const Ray<TypeParam> across{{-4, 0, 0.5}, {1, 0, 0}, 0, 10};  // 1 + x² = 4
  const auto found = roots(across, Hill{});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(double{found[0].lo}, 4 - std::sqrt(3.0), 1e-5);
  EXPECT_NEAR(double{found[1].hi}, 4 + std::sqrt(3.0), 1e-5);
}

}  // namespace
}  // namespace rayproof::implicit
