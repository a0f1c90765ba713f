#include "viz/picture/picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rayproof::viz {
namespace {

double area_of(const std::vector<Strip>& strips) {
  double twice = 0;
  for (const Strip& strip : strips) {
    double own = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point &a = strip[i], &b = strip[(i + 1) % 4];
      own += a.x * b.y - a.y * b.x;
    }
    twice += std::abs(own);
  }
  return twice / 2;
}

TEST(EvenOddStrips, ABowTieIsTwoTriangles) {
  const auto strips = even_odd_strips({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  EXPECT_NEAR(area_of(strips), 2, 1e-12);
}

TEST(EvenOddStrips, AStarsMiddleIsOutside) {
  std::vector<Point> ring;
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * std::numbers::pi * (0.25 + 2 * i / 5.0);
    ring.push_back({std::cos(angle), std::sin(angle)});
  }
  const auto strips = even_odd_strips(ring);
  const auto holds = [&](const Point& p) {
    for (const Strip& s : strips) {
      const double part = (p.y - s[0].y) / (s[2].y - s[0].y);
      if (part < 0 || part > 1) continue;
      const double left = s[0].x + part * (s[3].x - s[0].x), right = s[1].x + part * (s[2].x - s[1].x);
      if (left <= p.x && p.x <= right) return true;
    }
    return false;
  };
  EXPECT_FALSE(holds({0.01, 0.02}));
  EXPECT_TRUE(holds({0.01, 0.7}));
  EXPECT_FALSE(holds({0.01, -0.6})) << "between two points of the star";
}

TEST(EvenOddStrips, ATangleHasNotManyMoreThanAPictureShows) {
  std::vector<Point> ring;
  for (int i = 0; i < 1000; ++i)
    ring.push_back({(i % 2 == 0 ? 1 : -1) * static_cast<double>(i % 317), static_cast<double>(i * i % 1009)});
  const auto strips = even_odd_strips(ring);
  EXPECT_LE(strips.size(), 40'000U);
  EXPECT_GT(strips.size(), 1'000U);
}

TEST(EvenOddStrips, ARingThatDoesNotCrossItselfNeedsNone) {
  EXPECT_TRUE(even_odd_strips({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}}).empty());
}

}  // namespace
}  // namespace rayproof::viz
