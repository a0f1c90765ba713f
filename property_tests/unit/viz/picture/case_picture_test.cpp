#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <rayproof/topics.hpp>

#include "oracle/oracle.hpp"
#include "subjects/subject.hpp"
#include "unit/viz/every_shape.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/shapes/figure.hpp"
#include "viz/shapes/topics.hpp"

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

/// Both answers beside the case.
CaseSheet sheet_of(const Case& one, const Answer& exact, const Answer& claimed) {
  return case_sheet({.one = one, .exact = exact, .claimed = claimed});
}

/// Marks within the frames: the table below them has its own.
std::size_t count_marks(const Picture& picture, const CaseSheet& sheet, MarkShape shape) {
  const double bottom = sheet.frames.front().bottom();
  std::size_t count = 0;
  for (const Mark& mark : elements<Mark>(picture))
    count += mark.shape == shape && mark.at.y < bottom ? 1U : 0U;
  return count;
}

bool says(const Picture& picture, const std::string& words) {
  const auto texts = elements<Text>(picture);
  return std::any_of(texts.begin(), texts.end(), [&](const Text& text) { return text.text == words; });
}

TEST(Figure, OfEveryShapeHasPointsAndAnOutline) {
  for (const std::string& shape : shapes()) {
    const Case one = with_shape(shape);
    const Answer exact = oracle::answer(one);
    const Figure figure = scene_of(one, &exact, nullptr).figure;
    EXPECT_FALSE(figure.points.empty()) << shape;
    EXPECT_FALSE(figure.borders.empty() && figure.grid.empty()) << shape;
  }
}

TEST(CasePicture, MarksEveryHitOfEveryShape) {
  for (const std::string& shape : shapes()) {
    const Case one = with_shape(shape);
    const Answer exact = oracle::answer(one);
    const std::size_t hits = std::get<RayAnswer>(exact).hits.count;
    const CaseReport report{.one = one, .exact = exact, .claimed = exact};
    const Picture picture = case_picture(report);
    EXPECT_GE(count_marks(picture, case_sheet(report), MarkShape::ring), hits) << shape;
    EXPECT_GE(count_marks(picture, case_sheet(report), MarkShape::cross), hits) << shape;
    EXPECT_GE(hits, 1U) << shape;
    EXPECT_FALSE(elements<Area>(picture).empty()) << shape;
  }
}

TEST(CasePicture, AHugeATinyAndAFarSceneStayInsideThePicture) {
  for (const std::string& shape : shapes()) {
    for (const char* const matrix : {"[[1e150,0,0,0],[0,1e150,0,0],[0,0,1e150,0],[0,0,0,1]]",
                                     "[[1e-150,0,0,0],[0,1e-150,0,0],[0,0,1e-150,0],[0,0,0,1]]",
                                     "[[1,0,0,1e200],[0,1,0,0],[0,0,1e-200,0],[0,0,0,1]]"}) {
      const Case one = read_case(R"({"ray":{"origin":[1,2,-5],"direction":[0,0.1,1]},"transform":)" +
                                 std::string(matrix) + R"(,"shape":)" + shape + "}");
      const Picture picture = case_picture({.one = one, .exact = oracle::answer(one)});
      for (const PixelLine& line : elements<PixelLine>(picture)) {
        for (const Point& p : line.points) {
          ASSERT_TRUE(p.x >= 0 && p.x <= picture.width && p.y >= 0 && p.y <= picture.height)
              << shape << matrix << p.x << ' ' << p.y;
        }
      }
    }
  }
}

TEST(CasePicture, AGapTooNarrowToSeeIsMagnified) {
  RayAnswer hit{Contact::crossing};
  hit.hits.push_back(5);
  for (const char* const shape :
       {R"({"type":"triangle","a":[0,0,0],"b":[1,0,0],"c":[0,1,0]})",
        R"({"type":"box","min":[0,0,0],"max":[1,1,1]})", R"({"type":"cylinder","rx":1,"ry":1,"height":1})"}) {
    const bool is_round = std::string(shape).find("cylinder") != std::string::npos;
    const Case one =
        read_case(std::string(is_round ? R"({"ray":{"origin":[-5,0,-1e-9],"direction":[1,0,0]})"
                                       : R"({"ray":{"origin":[0.3,-1e-9,-5],"direction":[0,0,1]})") +
                  R"(,"shape":)" + shape + "}");
    const Picture picture = case_picture({.one = one, .exact = oracle::answer(one), .claimed = Answer(hit)});
    EXPECT_TRUE(says(picture, "1e-9 between")) << shape;
    EXPECT_TRUE(says(picture, "The ray passes 1e-9 from the outline.")) << shape;
  }
}

TEST(CasePicture, APointTooNearToAPolygonsSideIsMagnifiedAndItsCrossingsAreCounted) {
  const Case one =
      read_case(R"({"query":"point_in_polygon","point":[-1e-9,0.5],"vertices":[[0,0],[1,0],[1,1],[0,1]]})");
  const Answer claimed = Position::inside;
  const Picture picture = case_picture({.one = one, .exact = oracle::answer(one), .claimed = claimed});
  for (const char* const words : {"1e-9 between", "1", "2"}) EXPECT_TRUE(says(picture, words)) << words;
}

TEST(CasePicture, AFarStartIsNamedWhereTheShapeIsSeenFromNearby) {
  const Case one = read_case(
      R"({"ray":{"origin":[0,0,-9000],"direction":[0,0,1]},"shape":{"type":"sphere","center":[0,0,0],"radius":1}})");
  const Picture picture = case_picture({.one = one, .exact = oracle::answer(one)});
  EXPECT_TRUE(says(picture, "← o, 9000 off"));
  EXPECT_TRUE(says(picture, "Whole"));
}

TEST(CasePicture, ACallOfParallelForARayInThePlaneIsWrong) {
  const Case one = read_case(
      R"({"ray":{"origin":[0,0,1],"direction":[1,0,0]},"shape":{"type":"plane","normal":[0,0,1],"d":-1}})");
  const Answer claimed = find_subject("plane/printed_parallel")->answer(one);
  EXPECT_EQ(sheet_of(one, oracle::answer(one), claimed).picture.title,
            "Exact: miss (in the surface). Claimed: miss (parallel), which is wrong.");
}

TEST(Camera, SeesNeitherTheRayEndOnNorAFigureEdgeOn) {
  for (const glm::dvec3& v : {glm::dvec3{0, 0, 1}, {1, 0, 0}, {1, 2, 3}, {0, -1, 1e-9}}) {
    for (const glm::dvec3& w : {glm::dvec3{0, 0, 1}, {0, 1, 0}, {1, -1, 1}}) {
      const glm::dvec3 ray = glm::normalize(v);
      const glm::dvec3 normal = glm::normalize(w);
      const StageCamera camera = chosen_camera(ray, {normal});
      EXPECT_LT(std::abs(glm::dot(camera.toward, ray)), 0.75);
      EXPECT_GT(std::abs(glm::dot(camera.toward, normal)), 0.4);
      EXPECT_NEAR(glm::dot(camera.up, ray), 0, 1e-15);
      EXPECT_GT(glm::dot(camera.right, ray), 0.5);
    }
  }
}

TEST(Outline, OfABoxSeenFromACornerIsThreeFacesNineEdgesAndThreeHiddenOnes) {
  const Figure box = solid_figure({0, 0, 0}, {Place{1, 0, 0}, Place{0, -1, 0}, Place{0, 0, 1}});
  const StageItem item{Role::surface, Form::solid, rounded(box.points), {}, Pattern::solid, box.faces};
  StageCamera camera;
  camera.toward = glm::normalize(glm::dvec3(1, 2, 3));
  const SurfaceOutline outline = surface_outline(item, camera);
  EXPECT_EQ(outline.filled.size(), 3U);
  EXPECT_EQ(outline.seen.size(), 9U);
  EXPECT_EQ(outline.hidden.size(), 3U);
}

TEST(Outline, OfAnEllipsoidReachesAsFarAsItsAxes) {
  const StageItem item{Role::surface, Form::ellipsoid, {{1, 0, 0}, {4, 0, 0}, {1, 2, 0}, {1, 0, 9}}};
  const SurfaceOutline outline = surface_outline(item, {});
  double most = 0;
  for (const glm::dvec3& p : outline.seen.front()) most = std::max(most, p.x);
  EXPECT_NEAR(most, 4, 1e-9);
}

}  // namespace
}  // namespace rayproof::viz
