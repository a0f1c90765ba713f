/// \file
/// Rays and patches whose hits are known beforehand, by name.

#include <gtest/gtest.h>

#include <rayproof/parametric/bilinear_quadratic.hpp>
#include <rayproof/parametric/hits.hpp>

namespace rayproof::parametric {
namespace {

template <class T>
class PatchHitsOf : public testing::Test {
 protected:
  static constexpr T inf = infinity<T>;
  static constexpr T nan = not_a_number<T>;
  /// z = x·y over the unit square.
  const BilinearPatch<T> saddle_{{{{{{0, 0, 0}, {0, 1, 0}}}, {{{1, 0, 0}, {1, 1, 1}}}}}};
  const Ray<T> down_{{0.25, 0.5, 3}, {0, 0, -1}};

  /// The patch z = h(x, y) of a bicubic net over the unit square, h the product of two cubics.
  [[nodiscard]] static BicubicPatch<T> hill(const std::array<T, 4>& along_x,
                                            const std::array<T, 4>& along_y) {
    BicubicPatch<T> patch{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        patch.points[i][j] = {static_cast<T>(i) / 3, static_cast<T>(j) / 3, along_x[i] * along_y[j]};
    return patch;
  }

  static void expect_one(const PatchHits<T>& found, T t, T u, T v) {
    ASSERT_EQ(found.size(), 1U);
    constexpr T near = 16 * std::numeric_limits<T>::epsilon();
    EXPECT_TRUE(found[0].is_certain);
    EXPECT_NEAR(found[0].t, t, near * abs(t));
    EXPECT_NEAR(found[0].u, u, near);
    EXPECT_NEAR(found[0].v, v, near);
    EXPECT_LE(found[0].residual, near * abs(t));
  }
  static void expect_none(const PatchHits<T>& found) { EXPECT_TRUE(found.empty()); }
  static void expect_undecided(const PatchHits<T>& found) {
    EXPECT_FALSE(found.empty());
    for (const auto& hit : found) EXPECT_FALSE(hit.is_certain);
  }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(PatchHitsOf, Precisions);

TYPED_TEST(PatchHitsOf, MeetASaddleFromAbove) {
  this->expect_one(hits(this->down_, this->saddle_), TypeParam(2.875), TypeParam(0.25), TypeParam(0.5));
}

TYPED_TEST(PatchHitsOf, CrossASaddleTwiceAlongItsArch) {
  // z = x·y over x + y = 1 is an arch of height 1/4; at height 3/16 it stands 1/2 wide.
  const Ray<TypeParam> ray{{0, 1, 0.1875}, {1, -1, 0}};
  const auto found = hits(ray, this->saddle_);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].t, 0.25, 1e-6);
  EXPECT_NEAR(found[1].t, 0.75, 1e-6);
  EXPECT_TRUE(found[0].is_certain && found[1].is_certain);
}

TYPED_TEST(PatchHitsOf, AreUndecidedOnASilhouette) {
  const Ray<TypeParam> over{{0, 1, 0.25}, {1, -1, 0}};
  const auto found = hits(over, this->saddle_);
  this->expect_undecided(found);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].t_range.contains(TypeParam(0.5)));
}

TYPED_TEST(PatchHitsOf, AreUndecidedOnTheEdgeAndTheCorner) {
  for (const auto& [x, y] : {std::pair<TypeParam, TypeParam>{0, 0.5}, {1, 0.5}, {0.5, 0}, {1, 1}, {0, 0}}) {
    const auto found = hits(Ray<TypeParam>{{x, y, 3}, {0, 0, -1}}, this->saddle_);
    ASSERT_EQ(found.size(), 1U);
    this->expect_undecided(found);
    EXPECT_NEAR(found[0].t, 3 - x * y, 1e-5);
    EXPECT_TRUE(found[0].u_range.contains(x) && found[0].v_range.contains(y));
  }
}

TYPED_TEST(PatchHitsOf, FindNothingBesideThePatchOrBehind) {
  this->expect_none(hits(Ray<TypeParam>{{-0.01, 0.5, 3}, {0, 0, -1}}, this->saddle_));
  this->expect_none(hits(Ray<TypeParam>{{0.25, 0.5, 3}, {0, 0, 1}}, this->saddle_));
  Ray<TypeParam> ray = this->down_;
  ray.t_max = 2;
  this->expect_none(hits(ray, this->saddle_));
}

TYPED_TEST(PatchHitsOf, CountAnEndOfTheIntervalAsUndecided) {
  Ray<TypeParam> ray = this->down_;
  ray.t_max = 2.875;
  const auto found = hits(ray, this->saddle_);
  ASSERT_EQ(found.size(), 1U);
  this->expect_undecided(found);
  EXPECT_TRUE(found[0].t_range.contains(TypeParam(2.875)));
  EXPECT_LE(found[0].t, ray.t_max);
}

TYPED_TEST(PatchHitsOf, StartOnTheSurface) {
  Ray<TypeParam> ray = this->down_;
  ray.origin.z = 0.125;
  const auto found = hits(ray, this->saddle_);
  ASSERT_EQ(found.size(), 1U);
  this->expect_undecided(found);
  EXPECT_TRUE(found[0].t_range.contains(TypeParam(0)));
}

TYPED_TEST(PatchHitsOf, AreUndecidedAlongARuling) {
  this->expect_undecided(hits(Ray<TypeParam>{{0.5, -1, -0.5}, {0, 1, 0.5}}, this->saddle_));
}

TYPED_TEST(PatchHitsOf, MissAParallelPlane) {
  const BilinearPatch<TypeParam> flat{{{{{{0, 0, 0}, {0, 1, 0}}}, {{{1, 0, 0}, {1, 1, 0}}}}}};
  this->expect_none(hits(Ray<TypeParam>{{-1, 0.5, 1}, {1, 0, 0}}, flat));
  this->expect_undecided(hits(Ray<TypeParam>{{-1, 0.5, 0}, {1, 0, 0}}, flat));
}

TYPED_TEST(PatchHitsOf, TakeAPatchWithoutAreaForUndecidedOrMissed) {
  const BilinearPatch<TypeParam> point{};
  this->expect_none(hits(this->down_, point));
  this->expect_undecided(hits(Ray<TypeParam>{{0, 0, 3}, {0, 0, -1}}, point));
}

TYPED_TEST(PatchHitsOf, HaveNoneForADirectionOfZeroAnEmptyIntervalNaNAndInfinity) {
  this->expect_none(hits(Ray<TypeParam>{{0.25, 0.5, 0.125}, {0, 0, 0}}, this->saddle_));
  this->expect_none(hits(Ray<TypeParam>{{0.25, 0.5, 3}, {0, 0, -1}, 5, 4}, this->saddle_));
  for (const TypeParam bad : {this->nan, this->inf}) {
    for (int i = 0; i < 6; ++i) {
      Ray<TypeParam> ray = this->down_;
      (i < 3 ? ray.origin[i] : ray.direction[i - 3]) = bad;
      this->expect_none(hits(ray, this->saddle_));
    }
  }
  for (int corner = 0; corner < 4; ++corner) {
    BilinearPatch<TypeParam> patch = this->saddle_;
    patch.points[static_cast<std::size_t>(corner / 2)][static_cast<std::size_t>(corner % 2)].z = this->nan;
    this->expect_none(hits(this->down_, patch));
  }
}

TYPED_TEST(PatchHitsOf, MeetABicubicHill) {
  const auto hill = this->hill({0, 1, 1, 0}, {0, 1, 1, 0});  // h = 9·x(1-x)·y(1-y)
  this->expect_one(hits(this->down_, hill), TypeParam(3 - 9 * 0.1875 * 0.25), TypeParam(0.25),
                   TypeParam(0.5));
  const Ray<TypeParam> through{{-1, 0.5, 0.421875}, {1, 0, 0}};  // 2.25·x(1-x) = 0.421875 at 1/4 and 3/4
  const auto found = hits(through, hill);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].t, 1.25, 1e-5);
  EXPECT_NEAR(found[1].t, 1.75, 1e-5);
}

TYPED_TEST(PatchHitsOf, MeetABicubicWaveThrice) {
  const auto wave = this->hill({-1, 5, -5, 1}, {1, 1, 1, 1});
  const auto found = hits(Ray<TypeParam>{{-1, 0.375, 0}, {1, 0, 0}}, wave);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_NEAR(found[1].t, 1.5, 1e-5);
  for (const auto& hit : found) EXPECT_TRUE(hit.is_certain);
}

/// A surface of one's own: a paraboloid.
struct Bowl {
  template <class T>
  Vec3<T> operator()(const T& u, const T& v) const {
    return {u, v, square(u) + square(v)};
  }
};

TYPED_TEST(PatchHitsOf, TakeAnyFormulaOfTheArithmetic) {
  this->expect_one(hits(this->down_, Bowl{}), TypeParam(3 - 0.3125), TypeParam(0.25), TypeParam(0.5));
}

TYPED_TEST(PatchHitsOf, LeaveWhatTheBudgetDoesNotReachUndecided) {
  const Ray<TypeParam> through{{-1, 0.5, 0}, {1, 0, 0}};
  const auto found = hits(through, this->hill({-1, 5, -5, 1}, {1, 1, 1, 1}), 0);
  this->expect_undecided(found);
}

TYPED_TEST(PatchHitsOf, AgreeWithTheClosedFormOfTheBilinearPatch) {
  const auto closed = BilinearQuadratic::roots(this->down_, this->saddle_);
  const auto& one = closed[0].t == closed[0].t ? closed[0] : closed[1];
  EXPECT_NEAR(one.t, 2.875, 1e-5);
  EXPECT_NEAR(one.u, 0.25, 1e-5);
  EXPECT_NEAR(one.v, 0.5, 1e-5);
}

}  // namespace
}  // namespace rayproof::parametric
