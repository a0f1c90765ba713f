/// \file
/// Where rays start that leave surfaces: special values by name.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <rayproof/spawn.hpp>

namespace rayproof::spawn {

namespace {

/// The origin of a ray that leaves the shape at p.
template <class Strategy, class T>
vec3<T> origin_at(const auto& shape, const vec3<T>& p, Side side = Side::front) {
  return Strategy::origin(towards(side, leave(surface_of(shape), p)));
}

template <class T>
Box<T> unit_box() {
  return {{0, 0, 0}, {1, 1, 1}};
}

template <class T>
class LeavingIn : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(LeavingIn, Precisions);

TYPED_TEST(LeavingIn, ABoxByOurOffsetTakesOneNumberBeyondTheFace) {
  using T = TypeParam;
  const vec3<T> above = origin_at<Proven, T>(unit_box<T>(), {T(0.5), T(0.25), 1});
  EXPECT_EQ(above, (vec3<T>{T(0.5), T(0.25), std::nextafter(T(1), T(2))}));
  const vec3<T> below = origin_at<Proven, T>(unit_box<T>(), {T(0.5), T(0.25), 1}, Side::back);
  EXPECT_EQ(below, (vec3<T>{T(0.5), T(0.25), std::nextafter(T(1), T(0))}));
}

TYPED_TEST(LeavingIn, AFaceThroughZeroIsStillAMove) {
  using T = TypeParam;
  const vec3<T> out = origin_at<Proven, T>(unit_box<T>(), {0, T(0.5), T(0.5)});
  EXPECT_LT(out.x, 0);
  EXPECT_GT(out.x, -std::numeric_limits<T>::epsilon() * std::numeric_limits<T>::epsilon());
  const Plane<T> floor{PlaneForm::implicit, {}, {0, 0, 2}, 0, {}, {}};
  EXPECT_GT((origin_at<Proven, T>(floor, {3, 4, 0}).z), 0);
  EXPECT_LT((origin_at<Proven, T>(floor, {3, 4, 0}, Side::back).z), 0);
}

TYPED_TEST(LeavingIn, AnEdgeIsLeftInsideTheNextFaceToo) {
  using T = TypeParam;
  for (const vec3<T>& corner : {vec3<T>{1, 1, 1}, vec3<T>{0, 0, 0}, vec3<T>{0, 1, T(0.5)}}) {
    const vec3<T> in = origin_at<Proven, T>(unit_box<T>(), corner, Side::back);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GT(in[axis], 0);
      EXPECT_LT(in[axis], 1);
    }
  }
}

// Found by a ray from so far away that its hit is beside the solid by hundreds of times what that is thick.
TEST(Leaving, AHitFarBesideAThinParallelepipedComesInsideIt) {
  const Parallelepiped<float> solid{{31.778744F, -19.683132F, -27.887175F},
                                    {{{-50.727757F, 23.200308F, 20.901394F},
                                      {20.25298F, -0.48497197F, 16.696533F},
                                      {0.4612667F, 4.938184F, 14.603299F}}}};
  const glm::dvec3 from =
      glm::dvec3(origin_at<Proven, float>(solid, {-4, -64, -8}, Side::back)) - glm::dvec3(solid.corner);
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 across =
        glm::cross(glm::dvec3(solid.edges[(i + 1) % 3]), glm::dvec3(solid.edges[(i + 2) % 3]));
    const double along = glm::dot(across, from) / glm::dot(across, glm::dvec3(solid.edges[i]));
    EXPECT_GT(along, 0) << i;
    EXPECT_LT(along, 1) << i;
  }
}

// Found by rays from so far away that their hits, at (0, 0, 0), are beside the box.
TYPED_TEST(LeavingIn, AHitBesideTheNextFaceComesInsideItToo) {
  using T = TypeParam;
  const Box<T> below{{-1, 0, 0}, {T(-0.1), 1, 1}}, above{{T(1e-8), 0, 0}, {1, 1, 1}};
  EXPECT_LT((origin_at<Proven, T>(below, {0, 0, 0}, Side::back).x), T(-0.1));
  EXPECT_GT((origin_at<Proven, T>(above, {0, 0, 0}, Side::back).x), T(1e-8));
}

TYPED_TEST(LeavingIn, ASphereMovesTheHitOntoItFirst) {
  using T = TypeParam;
  const Sphere<T> ball{{0, 0, 5}, 1};
  const vec3<T> out = origin_at<Proven, T>(ball, {0, 0, T(3.5)});
  EXPECT_LT(out.z, 4);
  EXPECT_GT(out.z, 4 - 32 * std::numeric_limits<T>::epsilon());
}

TYPED_TEST(LeavingIn, ACylinderIsLeftThroughItsSideAndItsCaps) {
  using T = TypeParam;
  const Cylinder<T> tube{1, 2, 3, true};
  EXPECT_GT((origin_at<Proven, T>(tube, {1, 0, 1}).x), 1);
  EXPECT_LT((origin_at<Proven, T>(tube, {1, 0, 1}, Side::back).x), 1);
  EXPECT_GT((origin_at<Proven, T>(tube, {T(0.5), 0, 3}).z), 3);
  EXPECT_LT((origin_at<Proven, T>(tube, {T(0.5), 0, 0}).z), 0);
  for (const T x : {T(0), std::numeric_limits<T>::min()}) {  // of which the square is 0
    EXPECT_GT((origin_at<Proven, T>(tube, {x, 0, 3}).z), 3) << "at a cap's centre";
    EXPECT_LT((origin_at<Proven, T>(tube, {x, 0, 0}, Side::front).z), 0) << "at a cap's centre";
  }
  const vec3<T> in = origin_at<Proven, T>(tube, {1, 0, 3}, Side::back);  // on the rim
  EXPECT_LT(in.x, 1);
  EXPECT_LT(in.z, 3);
}

TYPED_TEST(LeavingIn, HugeAndTinyScenesAreLeftByTheSameDigits) {
  using T = TypeParam;
  for (const T size : {T(0x1p-20), T(0x1p20)}) {
    const Sphere<T> ball{{0, 0, 0}, size}, one{{0, 0, 0}, 1};
    const vec3<T> scaled = origin_at<Proven, T>(ball, {size * T(0.6), 0, size * T(0.8)});
    const vec3<T> unit_sized = origin_at<Proven, T>(one, {T(0.6), 0, T(0.8)});
    EXPECT_EQ(scaled, size * unit_sized);
  }
}

TYPED_TEST(LeavingIn, AThinTriangleKeepsItsNormal) {
  using T = TypeParam;
  const T thin = std::numeric_limits<T>::epsilon();
  const Triangle<T> sliver{{1, 1, 1}, {2, 1, 1}, {2, 1 + thin, 1}};
  EXPECT_EQ((leave(surface_of(sliver), vec3<T>{T(1.5), 1, 1}).normal), (vec3<T>{0, 0, 1}));
}

TYPED_TEST(LeavingIn, APlaneGivenByAFarPointIsSeenFromNearZero) {
  using T = TypeParam;
  const T far = T(0x1p20);
  const Plane<T> floor{PlaneForm::point_normal, {far, -far, 1}, {0, 0, 1}, {}, {}, {}};
  EXPECT_EQ((surface_of(floor).anchor), (vec3<T>{0, 0, 1}));
  EXPECT_LT((origin_at<Proven, T>(floor, {1, 1, 1}).z), 1 + 16 * std::numeric_limits<T>::epsilon());
}

TYPED_TEST(LeavingIn, AMapIsLeftInTheWorld) {
  using T = TypeParam;
  glm::mat<4, 4, T> map(T(1));
  map[2][2] = 2;
  map[3][2] = 10;
  const auto surface = surface_of(Sphere<T>{{0, 0, 0}, 1});
  const vec3<T> out = Proven::origin(leave(surface, placement<T>(map), vec3<T>{0, 0, 8}));
  EXPECT_LT(out.z, 8);
  EXPECT_GT(out.z, 8 - 256 * std::numeric_limits<T>::epsilon());
}

TYPED_TEST(LeavingIn, NaNGivesNoOrigin) {
  using T = TypeParam;
  const vec3<T> nowhere(std::numeric_limits<T>::quiet_NaN());
  EXPECT_TRUE(std::isnan(origin_at<Proven, T>(Sphere<T>{{0, 0, 0}, 1}, nowhere).x));
  EXPECT_TRUE(std::isnan(origin_at<Fixed, T>(Sphere<T>{{0, 0, 0}, 1}, nowhere).x));
  const Triangle<T> in_a_line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  EXPECT_TRUE(std::isnan(origin_at<IntegerOffset, T>(in_a_line, {1, 0, 0}).y)) << "it has no normal";
  EXPECT_TRUE(std::isnan(leave(surface_of(Polygon<T>{}), vec3<T>{1, 0, 0}).normal.x))
      << "nor has one of nothing";
}

TYPED_TEST(LeavingIn, AMapWithoutInverseGivesNoOrigin) {
  using T = TypeParam;
  glm::mat<4, 4, T> flattened(T(1));
  flattened[0][0] = 0;
  const Placement<T> map = placement<T>(flattened);
  const auto expect_none = [&](const auto& shape) {
    const vec3<T> from = Proven::origin(leave(surface_of(shape), map, vec3<T>{0, T(0.25), 1}));
    EXPECT_TRUE(std::isnan(from.x) || std::isnan(from.y) || std::isnan(from.z));
  };
  expect_none(Sphere<T>{{0, 0, 0}, 1});
  expect_none(unit_box<T>());
  expect_none(Cylinder<T>{1, 1, 1, true});
  expect_none(Parallelepiped<T>{{0, 0, 0}, {vec3<T>{1, 0, 0}, vec3<T>{0, 1, 0}, vec3<T>{0, 0, 1}}});
  expect_none(Triangle<T>{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
}

TEST(TheFixedOffset, IsTenToTheMinusFour) {
  EXPECT_EQ((origin_at<Fixed, double>(unit_box<double>(), {0.5, 0.5, 1}).z), 1 + 1e-4);
  EXPECT_EQ((origin_at<Nothing, double>(unit_box<double>(), {0.5, 0.5, 1}).z), 1);
}

TEST(TheRelativeOffset, IsMitsubas) {
  const float of_one = 1500 * 0x1p-24F * (1 + 1);
  EXPECT_EQ((origin_at<Relative, float>(unit_box<float>(), {0.5F, 0.5F, 1}).z), 1 + of_one);
}

/// The figures are those of the published code, run on these points.
TEST(TheIntegerOffset, IsTheSourcesOwn) {
  EXPECT_EQ(moved_by_steps(1.0F, 256.0F), 1 + 256 * 0x1p-23F);
  EXPECT_EQ(moved_by_steps(-1.0F, 256.0F), -1 + 256 * 0x1p-24F);
  // Below -0 no number follows; as a constant, what is not defined would not compile.
  static_assert(moved_by_steps(-0.0F, -1.0F) != moved_by_steps(-0.0F, -1.0F));
  static_assert(moved_by_steps(-0.0, -1.0) != moved_by_steps(-0.0, -1.0));
  EXPECT_EQ((origin_at<IntegerOffset, float>(unit_box<float>(), {0.5F, 0.5F, 1}).z), 1 + 256 * 0x1p-23F);
  EXPECT_EQ((origin_at<IntegerOffset, float>(unit_box<float>(), {0.5F, 0.5F, 0}).z), -0x1p-16F);
}

/// A box face is exact: its error box has no size, and the source's formula does not move.
TEST(TheErrorBoundsOffset, DoesNotMoveWhereThereIsNoError) {
  EXPECT_EQ((origin_at<ErrorBounds, float>(unit_box<float>(), {0.5F, 0.5F, 1}).z), 1);
  EXPECT_GT((origin_at<ErrorBounds, float>(Sphere<float>{{0, 0, 0}, 1}, {0, 0, 1}).z), 1);
}

}  // namespace

}  // namespace rayproof::spawn
