#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <rayproof/topics.hpp>

#include "oracle/oracle.hpp"
#include "subjects/subject.hpp"
#include "unit/viz/every_shape.hpp"
#include "viz/drawing/even_odd.hpp"
#include "viz/drawing/topics.hpp"
#include "viz/drawing/topics/camera.hpp"
#include "viz/drawing/topics/figure.hpp"

namespace rayproof::viz {
namespace {

template <class Kind>
std::vector<Kind> elements(const Picture& picture) {
  std::vector<Kind> found;
  for (const Element& element : picture.elements) {
    if (const auto* one = std::get_if<Kind>(&element)) found.push_back(*one);
  }
  return found;
}

/// Marks inside the first frame, the table's own below it left out.
std::size_t count_marks(const Picture& picture, MarkShape shape) {
  std::size_t count = 0;
  for (const Mark& mark : elements<Mark>(picture)) count += mark.shape == shape && mark.at.y < 388 ? 1U : 0U;
  return count;
}

TEST(Views, EveryTopicHasOne) {
  Topics::for_each([]<class Topic>(std::type_identity<Topic>) {
    const auto& views = topic_views();
    EXPECT_EQ(std::count_if(views.begin(), views.end(), [](const auto& v) { return v.name == Topic::name; }),
              1)
        << Topic::name;
  });
}

TEST(Wireframe, MarksEveryHitOfEveryShape) {
  for (const std::string& shape : shapes()) {
    const Case one = with_shape(shape);
    const Answer exact = oracle::answer(one);
    const std::size_t hits = std::get<RayAnswer>(exact).hits.count;
    const Picture picture = view_of(one)->picture(one, &exact, &exact);
    EXPECT_GE(count_marks(picture, MarkShape::ring), hits) << shape;
    EXPECT_GE(count_marks(picture, MarkShape::cross), hits) << shape;
    EXPECT_GE(hits, 1U) << shape;
    EXPECT_FALSE(elements<Area>(picture).empty()) << shape;
  }
}

TEST(Wireframe, AHugeATinyAndAFarSceneStayInsideThePicture) {
  for (const std::string& shape : shapes()) {
    for (const char* const matrix : {"[[1e150,0,0,0],[0,1e150,0,0],[0,0,1e150,0],[0,0,0,1]]",
                                     "[[1e-150,0,0,0],[0,1e-150,0,0],[0,0,1e-150,0],[0,0,0,1]]",
                                     "[[1,0,0,1e200],[0,1,0,0],[0,0,1e-200,0],[0,0,0,1]]"}) {
      const Case one = read_case(R"({"ray":{"origin":[1,2,-5],"direction":[0,0.1,1]},"transform":)" +
                                 std::string(matrix) + R"(,"shape":)" + shape + "}");
      const Answer exact = oracle::answer(one);
      const Picture picture = view_of(one)->picture(one, &exact, nullptr);
      for (const PixelLine& line : elements<PixelLine>(picture)) {
        for (const Point& p : line.points) {
          ASSERT_TRUE(p.x >= 0 && p.x <= picture.width && p.y >= 0 && p.y <= picture.height)
              << shape << matrix << p.x << ' ' << p.y;
        }
      }
    }
  }
}

TEST(Wireframe, AGapTooNarrowToSeeIsMagnified) {
  const Case one = read_case(
      R"({"ray":{"origin":[0.3,-1e-9,-5],"direction":[0,0,1]},"shape":{"type":"triangle","a":[0,0,0],"b":[1,0,0],"c":[0,1,0]}})");
  const Answer exact = oracle::answer(one);
  RayAnswer wrong{Contact::crossing};
  wrong.hits.push_back(5);
  const Answer claimed = wrong;
  bool is_shown = false;
  const Picture picture = view_of(one)->picture(one, &exact, &claimed);
  for (const Text& text : elements<Text>(picture)) is_shown = is_shown || text.text == "1e-9 between";
  EXPECT_TRUE(is_shown);
}

TEST(Wireframe, ACallOfParallelForARayInThePlaneIsWrong) {
  const Case one = read_case(
      R"({"ray":{"origin":[0,0,1],"direction":[1,0,0]},"shape":{"type":"plane","normal":[0,0,1],"d":-1}})");
  const Answer exact = oracle::answer(one);
  const Answer claimed = find_subject("plane/printed_parallel")->answer(one);
  EXPECT_EQ(view_of(one)->picture(one, &exact, &claimed).title,
            "Exact: miss (in the surface). Claimed: miss (parallel), which is wrong.");
}

TEST(Camera, SeesNeitherTheRayEndOnNorAFigureEdgeOn) {
  for (const Place& ray : {Place{0, 0, 1}, Place{1, 0, 0}, unit(Place{1, 2, 3}), unit(Place{0, -1, 1e-9})}) {
    for (const Place& normal : {Place{0, 0, 1}, Place{0, 1, 0}, unit(Place{1, -1, 1})}) {
      const ViewCamera camera = ViewCamera::chosen({0, 0, 0}, ray, {normal});
      EXPECT_LT(abs(dot(camera.toward, ray)), Shadow(0.75));
      EXPECT_GT(abs(dot(camera.toward, normal)), Shadow(0.4));
      EXPECT_LT(abs(camera.see(ray).y), Shadow(1e-60));
      EXPECT_GT(camera.see(ray).x, Shadow(0.5));
    }
  }
}

TEST(EvenOdd, FillsAStarsPointsAndNotItsHeart) {
  Picture picture;
  const View view{{0, 0, 200, 200}, {0, 0}, 100, 100};
  std::vector<WorldPoint> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = i * 4 * std::acos(-1.0) / 5;
    star.push_back({Shadow(std::sin(angle)), Shadow(std::cos(angle))});
  }
  draw_even_odd(picture, view, Role::surface, star);
  double area = 0;
  for (const Area& part : elements<Area>(picture)) {
    const double height = part.points[2].y - part.points[0].y;
    area += height * (part.points[1].x - part.points[0].x + part.points[2].x - part.points[3].x) / 2;
  }
  // Five points of a pentagram in the unit circle: 1.1226 in all less the heart of 0.3469.
  EXPECT_NEAR(area / 1e4, 1.1226 - 0.3469, 0.02);
}

TEST(ConvexHull, LeavesOutWhatLiesInside) {
  EXPECT_EQ(convex_hull({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 0}}).size(), 4U);
}

}  // namespace
}  // namespace rayproof::viz
