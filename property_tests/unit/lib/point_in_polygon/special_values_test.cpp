/// \file
/// Every point-in-polygon method on the cases that undo crossing counts, named one by one.

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <rayproof/point_in_polygon/methods.hpp>

namespace rayproof {

/// How a failed expectation prints a position.
inline void PrintTo(Position position, std::ostream* out) {
  *out << (position == Position::inside ? "inside" : position == Position::outside ? "outside" : "boundary");
}

namespace point_in_polygon {
namespace {

template <class T>
class EveryPointInPolygonMethod : public testing::Test {
 protected:
  using Vertices = std::vector<Vec2<T>>;
  static constexpr T nan = not_a_number<T>;

  const Vertices square_{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  /// A pentagram drawn in one line: its middle is wound about twice.
  const Vertices star_{{0, 5}, {3, -4}, {-5, 2}, {5, 2}, {-3, -4}};
  /// A square with a notch from above down to (2, 1).
  const Vertices notched_{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
  /// Level runs at y = 2 on the way up and at y = 4 on top.
  const Vertices stairs_{{0, 0}, {6, 0}, {6, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}};

  /// Expects `position` of every method but the printed one, however the polygon is run through.
  void expect(Position position, const Vec2<T>& point, Vertices vertices) {
    for (std::size_t turn = 0; turn < 2 * vertices.size(); ++turn) {
      SCOPED_TRACE(turn);
      Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
        SCOPED_TRACE(Method::name);
        if constexpr (!std::is_same_v<Method, PrintedParity>) {
          EXPECT_EQ(Method::locate(PointAndPolygon<T>{point, vertices}), position)
              << point.x << ", " << point.y;
        }
      });
      std::rotate(vertices.begin(), vertices.begin() + 1, vertices.end());
      if (turn + 1 == vertices.size()) std::reverse(vertices.begin(), vertices.end());
    }
  }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(EveryPointInPolygonMethod, Precisions);

TYPED_TEST(EveryPointInPolygonMethod, DistinguishesInsideFromOutside) {
  this->expect(Position::inside, {1, 1}, this->square_);
  this->expect(Position::outside, {5, 1}, this->square_);
  this->expect(Position::outside, {-1, 1}, this->square_);
  this->expect(Position::outside, {1, 5}, this->square_);
}

TYPED_TEST(EveryPointInPolygonMethod, CountsEverySideAndVertexAsBoundary) {
  for (const Vec2<TypeParam>& point :
       std::vector<Vec2<TypeParam>>{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}, {4, 1}, {3, 4}, {0, 2}}) {
    this->expect(Position::boundary, point, this->square_);
  }
  this->expect(Position::boundary, {2, 1}, this->notched_);
  this->expect(Position::boundary, {3, TypeParam(2.5)}, this->notched_);
}

TYPED_TEST(EveryPointInPolygonMethod, IsNotMisledByVerticesAtThePointsHeight) {
  this->expect(Position::inside, {1, 1}, this->notched_);
  this->expect(Position::inside, {3, 1}, this->notched_);
  this->expect(Position::outside, {-1, 1}, this->notched_);
  this->expect(Position::outside, {-1, 4}, this->notched_);
  this->expect(Position::outside, {2, 4}, this->notched_);
}

TYPED_TEST(EveryPointInPolygonMethod, IsNotMisledByHorizontalSidesAtThePointsHeight) {
  this->expect(Position::inside, {3, 2}, this->stairs_);
  this->expect(Position::boundary, {1, 2}, this->stairs_);
  this->expect(Position::boundary, {5, 2}, this->stairs_);
  this->expect(Position::outside, {-1, 2}, this->stairs_);
  this->expect(Position::outside, {7, 2}, this->stairs_);
  this->expect(Position::outside, {1, 4}, this->stairs_);
  this->expect(Position::outside, {-1, 0}, this->stairs_);
}

TYPED_TEST(EveryPointInPolygonMethod, FollowsTheEvenOddRuleWhereAPolygonWindsTwice) {
  this->expect(Position::outside, {0, 0}, this->star_);
  this->expect(Position::inside, {0, 4}, this->star_);
  this->expect(Position::inside, {-4, TypeParam(1.75)}, this->star_);
}

TYPED_TEST(EveryPointInPolygonMethod, TakesNoNoticeOfRepeatedVertices) {
  const std::vector<Vec2<TypeParam>> repeated{{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {4, 4}, {0, 4}};
  this->expect(Position::inside, {1, 1}, repeated);
  this->expect(Position::outside, {-1, 4}, repeated);
  this->expect(Position::outside, {-1, 0}, repeated);
  this->expect(Position::boundary, {4, 4}, repeated);
}

TYPED_TEST(EveryPointInPolygonMethod, FindsNothingInsideAFlatPolygon) {
  const std::vector<Vec2<TypeParam>> flat{{0, 0}, {4, 0}, {2, 0}};
  this->expect(Position::boundary, {3, 0}, flat);
  this->expect(Position::outside, {5, 0}, flat);
  this->expect(Position::outside, {-1, 0}, flat);
  const std::vector<Vec2<TypeParam>> point{{1, 1}, {1, 1}, {1, 1}};
  this->expect(Position::boundary, {1, 1}, point);
  this->expect(Position::outside, {0, 1}, point);
}

TYPED_TEST(EveryPointInPolygonMethod, TreatsMinusZeroAsZero) {
  const TypeParam zero(-0.0);
  this->expect(Position::boundary, {zero, 2}, this->square_);
  this->expect(Position::boundary, {1, zero}, this->square_);
  this->expect(Position::inside, {1, 1}, {{zero, zero}, {4, zero}, {4, 4}, {zero, 4}});
}

TYPED_TEST(EveryPointInPolygonMethod, IsOutsideOnNaNAnywhere) {
  using T = TypeParam;
  const auto expect_outside = [](const PointAndPolygon<T>& question) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      EXPECT_EQ(Method::locate(question), Position::outside) << Method::name;
    });
  };
  expect_outside({{this->nan, 1}, this->square_});
  expect_outside({{1, this->nan}, this->square_});
  for (std::size_t i = 0; i < this->square_.size(); ++i) {
    PointAndPolygon<T> question{{1, 1}, this->square_};
    question.vertices[i].x = this->nan;
    expect_outside(question);
    question = {{1, 1}, this->square_};
    question.vertices[i].y = this->nan;
    expect_outside(question);
  }
}

TYPED_TEST(EveryPointInPolygonMethod, CompensatedSeesTheLastBitBesideASlantedSide) {
  using T = TypeParam;
  const std::vector<Vec2<T>> triangle{{0, 0}, {3, 1}, {0, 1}};
  const T third = T(1) / T(3);  // a little more than a third in float, a little less in double
  const Position position = std::is_same_v<T, float> ? Position::inside : Position::outside;
  EXPECT_EQ(Compensated::locate(PointAndPolygon<T>{{1, third}, triangle}), position);
  EXPECT_EQ(Compensated::locate(PointAndPolygon<T>{{T(1.5), T(0.5)}, triangle}), Position::boundary);
}

TYPED_TEST(EveryPointInPolygonMethod, PrintedParityCountsAVertexTwice) {
  using T = TypeParam;
  const std::vector<Vec2<T>> diamond{{0, -2}, {2, 0}, {0, 2}, {-2, 0}};
  EXPECT_EQ(PrintedParity::locate(PointAndPolygon<T>{{0, 0}, diamond}), Position::outside);
  EXPECT_EQ(PrintedParity::locate(PointAndPolygon<T>{{0, T(0.5)}, diamond}), Position::inside);
}

TEST(Orientation, ChangesItsSignAndNothingElseWhereTheLineIsWalkedBackward) {
  for (int i = 1; i < 100; ++i) {
    const auto x = static_cast<float>(i);
    const Vec2<float> p{1 / x, 0.1F}, a{x / 7, x / 3}, b{0.3F, x * x / 11};
    EXPECT_EQ(orientation(p, a, b), -orientation(p, b, a));
  }
}

}  // namespace
}  // namespace point_in_polygon
}  // namespace rayproof
