/// \file
/// Cases of the point-in-polygon oracle whose answers are proved by hand.

#include <algorithm>
#include <cfloat>

#include "unit/oracle/cases.hpp"

namespace rayproof::oracle::test {
namespace {

using Outline = std::vector<Vec2<double>>;

Position place(double x, double y, const Outline& vertices) {
  return std::get<Position>(answer({.question = PointAndPolygon<double>{{x, y}, vertices}}));
}

const Outline square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Outline diamond{{0, -2}, {2, 0}, {0, 2}, {-2, 0}};
/// A comb whose two teeth end at y = 2 and whose gap reaches down to y = 1.
const Outline comb{{0, 0}, {5, 0}, {5, 2}, {3, 2}, {3, 1}, {2, 1}, {2, 2}, {0, 2}};

TEST(PointInPolygonOracle, KnowsTheThreePlaces) {
  EXPECT_EQ(place(1, 3, square), Position::inside);
  EXPECT_EQ(place(5, 3, square), Position::outside);
  EXPECT_EQ(place(4, 3, square), Position::boundary);
  EXPECT_EQ(place(3, 0, square), Position::boundary);
  EXPECT_EQ(place(4, 4, square), Position::boundary);
}

// A ray to the right or left of these points passes a vertex, or runs along a side.
TEST(PointInPolygonOracle, CountsAPassedVertexOnce) {
  EXPECT_EQ(place(0, 0, diamond), Position::inside);
  EXPECT_EQ(place(-3, 0, diamond), Position::outside);
  EXPECT_EQ(place(3, 0, diamond), Position::outside);
  EXPECT_EQ(place(-3, 2, diamond), Position::outside);
  EXPECT_EQ(place(-3, -2, diamond), Position::outside);
  EXPECT_EQ(place(-1, 1, comb), Position::outside);
  EXPECT_EQ(place(1, 1, comb), Position::inside);
  EXPECT_EQ(place(4, 1, comb), Position::inside);
  EXPECT_EQ(place(-1, 2, comb), Position::outside);
  EXPECT_EQ(place(2.5, 2, comb), Position::outside);
  EXPECT_EQ(place(2.5, 1, comb), Position::boundary);
  EXPECT_EQ(place(2.5, 1.5, comb), Position::outside);
}

TEST(PointInPolygonOracle, StepsOffTheBoundaryByTheSmallestNumber) {
  EXPECT_EQ(place(1, DBL_TRUE_MIN, square), Position::inside);
  EXPECT_EQ(place(1, -DBL_TRUE_MIN, square), Position::outside);
  EXPECT_EQ(place(1, std::nextafter(1.0, 2.0), diamond), Position::outside);
  EXPECT_EQ(place(1, std::nextafter(1.0, 0.0), diamond), Position::inside);
  EXPECT_EQ(place(std::nextafter(4.0, 5.0), 4, square), Position::outside);
}

TEST(PointInPolygonOracle, GoesByTheEvenOddRuleNotByTurns) {
  const Outline pentagram{{0, 10}, {6, -8}, {-10, 3}, {10, 3}, {-6, -8}};
  EXPECT_EQ(place(0, 0, pentagram), Position::outside);
  EXPECT_EQ(place(0, 8, pentagram), Position::inside);
  EXPECT_EQ(place(0, 3, pentagram), Position::boundary);
  Outline twice = square;
  twice.insert(twice.end(), square.begin(), square.end());
  EXPECT_EQ(place(1, 3, twice), Position::outside);
  EXPECT_EQ(place(0, 3, twice), Position::boundary);
}

TEST(PointInPolygonOracle, TakesOutlinesOfNoAreaForTheirBoundary) {
  const Outline segment{{0, 0}, {2, 2}, {1, 1}};
  EXPECT_EQ(place(1.5, 1.5, segment), Position::boundary);
  EXPECT_EQ(place(3, 3, segment), Position::outside);
  EXPECT_EQ(place(1, 1.5, segment), Position::outside);
  const Outline point{{1, 1}, {1, 1}, {1, 1}};
  EXPECT_EQ(place(1, 1, point), Position::boundary);
  EXPECT_EQ(place(0, 1, point), Position::outside);
}

TEST(PointInPolygonOracle, DoesNotMindTheDirectionOrTheStart) {
  for (Outline turned : {square, diamond, comb}) {
    for (std::size_t start = 0; start < turned.size(); ++start) {
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      const Outline reversed(turned.rbegin(), turned.rend());
      for (int x = -3; x <= 6; ++x) {
        for (int y = -3; y <= 6; ++y) EXPECT_EQ(place(x, y, turned), place(x, y, reversed));
      }
    }
  }
}

TEST(PointInPolygonOracle, BearsSubnormalsAndTheLargestNumbers) {
  const auto sized = [](double size) {
    return Outline{{0, 0}, {4 * size, 0}, {4 * size, 4 * size}, {0, 4 * size}};
  };
  for (const double size : {DBL_TRUE_MIN, 0x1p-1000, 0x1p+1000, DBL_MAX / 4}) {
    EXPECT_EQ(place(size, 3 * size, sized(size)), Position::inside);
    EXPECT_EQ(place(4 * size, 3 * size, sized(size)), Position::boundary);
    EXPECT_EQ(place(size, -size, sized(size)), Position::outside);
  }
  // (1, 1) lies on the side from (-MAX, -MAX) to (MAX, MAX), and the smallest step leaves it.
  const Outline vast{{-DBL_MAX, -DBL_MAX}, {DBL_MAX, DBL_MAX}, {-DBL_MAX, DBL_MAX}};
  EXPECT_EQ(place(1, 1, vast), Position::boundary);
  EXPECT_EQ(place(1, std::nextafter(1.0, 2.0), vast), Position::inside);
  EXPECT_EQ(place(1, std::nextafter(1.0, 0.0), vast), Position::outside);
}

}  // namespace
}  // namespace rayproof::oracle::test
