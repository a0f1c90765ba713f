/// \file
/// The judge of rays that leave: planted false hits are found, and its short ways agree with the oracle.

#include "oracle/leaving/leaving.hpp"

#include <gtest/gtest.h>

#include "generators/generators.hpp"
#include "oracle/oracle.hpp"

namespace rayproof::oracle {

namespace {

using spawn::Side;

RayQuestion ray_from(const glm::dvec3& origin, const glm::dvec3& direction, const Shape& shape) {
  return {{origin, direction}, shape};
}

const Sphere<double> ball{{0, 0, 0}, 1};
const Box<double> cube{{0, 0, 0}, {1, 1, 1}};
const Triangle<double> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST(Departure, OnTheSurfaceOrBelowItIsAFalseHit) {
  for (const double z : {1.0, 1 - 0x1p-53})
    EXPECT_EQ(depart(ray_from({0, 0, z}, {1, 0, 0}, ball), {}, Side::front), Departure::false_hit) << z;
  EXPECT_EQ(depart(ray_from({0, 0, 1 + 0x1p-52}, {1, 0, 0}, ball), {}, Side::front), Departure::clear);
  EXPECT_EQ(depart(ray_from({0.25, 0.25, 0}, {1, 1, 0.5}, triangle), {}, Side::front), Departure::false_hit);
  EXPECT_EQ(depart(ray_from({0.25, 0.25, -0x1p-1000}, {0, 0, 1}, triangle), {}, Side::front),
            Departure::false_hit);
  EXPECT_EQ(depart(ray_from({0.25, 0.25, 0x1p-1000}, {1, 0, 0}, triangle), {}, Side::front),
            Departure::clear);
}

TEST(Departure, BehindATriangleThatThePathPassesByIsNoFault) {
  EXPECT_EQ(depart(ray_from({0.25, 0.25, -1}, {1, 0, 0.5}, triangle), {}, Side::front), Departure::clear);
}

TEST(Departure, IntoASolidMustStartInside) {
  const SurfacePiece top{2, true};
  const glm::dvec3 down(0, 0, -1);
  EXPECT_EQ(depart(ray_from({0.5, 0.5, 1 - 0x1p-53}, down, cube), top, Side::back), Departure::clear);
  EXPECT_EQ(depart(ray_from({0.5, 0.5, 1}, down, cube), top, Side::back), Departure::false_hit);
  EXPECT_EQ(depart(ray_from({0.5, 0.5, -0x1p-60}, down, cube), top, Side::back), Departure::skipped);
}

TEST(Departure, BesideTheEdgeOfABoxIsNotInside) {
  const SurfacePiece top{2, true};
  const RayQuestion beside = ray_from({1, 0.5, 0.75}, {-1, 0, -1}, cube);
  EXPECT_EQ(depart(beside, top, Side::back), Departure::false_hit);
}

TEST(Departure, OfARayAlongTheSurfaceHangsOnTheOrigin) {
  EXPECT_EQ(depart(ray_from({1 + 0x1p-52, 0, 0}, {0, 1, 0}, ball), {}, Side::front), Departure::clear);
  EXPECT_EQ(depart(ray_from({1, 0, 0}, {0, 1, 0}, ball), {}, Side::front), Departure::false_hit);
}

TEST(ThePieceOfANormal, IsTheFaceItLooksFrom) {
  const SurfacePiece top = piece_of(cube, {0.01, -0.02, 0.9});
  EXPECT_EQ(top.index, 2);
  EXPECT_TRUE(top.is_upper);
  const Parallelepiped<double> slanted{{0, 0, 0}, {glm::dvec3{1, 0, 0}, {1, 1, 0}, {1, 1, -1}}};
  const SurfacePiece low = piece_of(slanted, {0, 0, 1});
  EXPECT_EQ(low.index, 2);
  EXPECT_FALSE(low.is_upper);
  EXPECT_EQ(piece_of(Cylinder<double>{1, 1, 1, true}, {0, 0, -1}).index, 1);
  EXPECT_EQ(piece_of(Cylinder<double>{1, 1, 1, true}, {0, 1, 0}).index, 0);
}

TEST(TheClimbOfADirection, IsExact) {
  EXPECT_EQ(climb(ray_from({0, 0, 1}, {1, 0, 0}, ball), {}), 0);
  EXPECT_EQ(climb(ray_from({0, 0, 1}, {1, 0, 0x1p-1000}, ball), {}), 1);
  EXPECT_EQ(climb(ray_from({0x1p-900, 0, 1}, {-1, 0, 0}, ball), {}), -1);
  RayQuestion mirrored = ray_from({0, 0, -1}, {1, 0, -0x1p-60}, ball);
  mirrored.transform = glm::dmat4(-1);
  (*mirrored.transform)[3][3] = 1;
  EXPECT_EQ(climb(mirrored, {}), 1);
  mirrored.shape = triangle;  // its normal, mirrored, looks down
  EXPECT_EQ(climb(mirrored, {}), 1);
}

/// On every family's rays, whatever leaves from the origin: what the judge calls clear to the front of a
/// convex shape has no exact hit, and what it calls a false hit has one.
TEST(Departure, AgreesWithTheExactAnswer) {
  int clear = 0, false_hits = 0;
  for (const Family& family : families())
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const Case one = family.generate(seed, Precision::float32);
      const auto* question = std::get_if<RayQuestion>(&one.question);
      if (question == nullptr) continue;
      Case whole = one;
      auto& ray = std::get<RayQuestion>(whole.question).ray;
      ray.t_min = 0;
      ray.t_max = infinity<double>;
      const RayQuestion& asked = std::get<RayQuestion>(whole.question);
      const bool has_hits = std::get<RayAnswer>(answer(whole)).hits.count > 0;
      for (const Side side : {Side::front, Side::back}) {
        if (side == Side::back && has_inside(asked.shape)) continue;
        const Departure departure = depart(asked, {}, side);
        EXPECT_EQ(departure == Departure::false_hit, has_hits) << family.topic << ' ' << family.name;
        ++(has_hits ? false_hits : clear);
      }
    }
  EXPECT_GT(clear, 1000);
  EXPECT_GT(false_hits, 1000);
}

}  // namespace

}  // namespace rayproof::oracle
