#include <gtest/gtest.h>
#include <vtkFeatureEdges.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "unit/viz/every_shape.hpp"
#include "unit/viz/stage_data.hpp"
#include "viz/scene/items.hpp"
#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/picture_png.hpp"
#include "viz/vtk/space/geometry.hpp"
#include "viz/vtk/space/space_scene.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace {

using namespace rayproof;
using namespace rayproof::viz;

double area_of(const Geometry& surface) {
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputConnection(triangles->GetOutputPort());
  mass->Update();
  return mass->GetSurfaceArea();
}

TEST(SpaceGeometry, ASolidHasItsFacesWhicheverWayTheyAreGiven) {
  SpacePoints corners;
  for (int i = 0; i < 8; ++i) corners.emplace_back((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1);
  const Geometry cube =
      solid_of(corners, {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}});
  EXPECT_NEAR(area_of(cube), 24, 1e-6);
}

TEST(SpaceGeometry, AConcavePolygonIsFilledWithoutItsNotch) {
  const Geometry notched = polygon_of({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.5, 0}, {0, 2, 0}});
  EXPECT_NEAR(area_of(notched), 4 - 1.5, 1e-6);
}

TEST(SpaceGeometry, AnEllipsoidReachesTheTipsOfItsAxes) {
  const Geometry ellipsoid = ellipsoid_of({{1, 0, 0}, {4, 0, 0}, {1, 2, 0}, {1, 0, 1}});
  const double* const bounds = ellipsoid->GetBounds();
  EXPECT_NEAR(bounds[0], -2, 0.01);
  EXPECT_NEAR(bounds[1], 4, 0.01);
  EXPECT_NEAR(bounds[3], 2, 0.01);
  EXPECT_NEAR(bounds[5], 1, 0.01);
}

TEST(SpaceGeometry, AnArrowEndsWhereItPoints) {
  const ArrowHead head{{0, 0, 0.9}, {0, 0, 1}, 0.03};
  const Geometry arrow = line_geometry({{{0, 0, 0}, {0, 0, 0.91}}}, head, 0.01);
  const double* const bounds = arrow->GetBounds();
  EXPECT_NEAR(bounds[5], 1, 1e-6);
  EXPECT_NEAR(bounds[4], 0, 1e-6);
}

TEST(SpaceGeometry, ADashedLineHasGapsAndEndsInsideTheLine) {
  const SpacePoints line{{0, 0, 0}, {1, 0, 0}};
  const Geometry solid = line_geometry({line}, {}, 0.01);
  const Geometry dashed = line_geometry(pieces_of(line, 0.01, Pattern::dashed), {}, 0.01);
  EXPECT_LT(area_of(dashed), 0.8 * area_of(solid));
  EXPECT_LE(dashed->GetBounds()[1], 1 + 1e-6);
}

TEST(Floor, HasItsLinesAtRoundNumbers) {
  EXPECT_DOUBLE_EQ(grid_step(2), 1);
  EXPECT_DOUBLE_EQ(grid_step(5), 2);
  EXPECT_DOUBLE_EQ(grid_step(10), 5);
  EXPECT_DOUBLE_EQ(grid_step(2e-3), 1e-3);
}

/// Where the camera's own numbers say that a point of the view is seen: a pinhole, or straight on.
Point pinhole(const SpaceCamera& camera, const PixelBox& frame, const glm::dvec3& p) {
  const glm::dvec3 right = glm::normalize(glm::cross(camera.up, camera.toward));
  const glm::dvec3 off = p - camera.eye();
  const double depth = -glm::dot(off, camera.toward);
  const double half =
      camera.is_flat ? camera.half : depth * std::tan(view_angle / 2 * std::numbers::pi / 180);
  const double scale = frame.height / 2 / half;
  return {frame.centre().x + scale * glm::dot(off, right),
          frame.centre().y - scale * glm::dot(off, glm::cross(camera.toward, right))};
}

// The same formula holds for the pages: property_tests/unit/pages/pinhole.py.
TEST(SpaceScene, SeesEveryPointWhereTheCamerasNumbersSay) {
  const OffscreenDisplay display;
  const PixelBox frame{10, 20, 640, 400};
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(800, 500);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  int count = 0;
  for (const char* lesson : {"sphere", "slabs", "parity"}) {
    for (const Lesson* one : lessons_of(lesson)) {
      const Stage stage = stage_of(*one, report_lesson);
      for (std::size_t step = 0; step < stage.steps.size(); ++step) {
        const SpaceScene scene(*renderer, stage, step);
        const Space space = space_of(stage, step);
        for (const ShownItem& shown : shown_in(stage, step)) {
          if (shown.item->form == Form::ellipsoid) continue;  // its outline, which is no point of the item
          const SpacePoints points = placed_points(*shown.item, space.view);
          const std::vector<Point> seen = scene.seen(*shown.item, frame);
          const auto is_behind = [&](const glm::dvec3& p) {
            return glm::dot(space.camera.eye() - p, space.camera.toward) < space.camera.nearest();
          };
          if (seen.empty() || std::any_of(points.begin(), points.end(), is_behind)) continue;
          for (std::size_t i = 0; i < points.size(); ++i, ++count) {
            const Point expected = pinhole(space.camera, frame, points[i]);
            const double tolerance = 0.01 + 1e-5 * std::hypot(expected.x, expected.y);
            EXPECT_NEAR(seen[i].x, expected.x, tolerance) << stage.name << ", step " << step + 1;
            EXPECT_NEAR(seen[i].y, expected.y, tolerance) << stage.name << ", step " << step + 1;
          }
        }
      }
    }
  }
  EXPECT_GT(count, 100);
}

TEST(SpaceScene, SeesOfALineThatPassesTheEyeThePartBeforeIt) {
  const OffscreenDisplay display;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(800, 500);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  Stage stage;
  stage.steps.emplace_back().items = {segment(Role::edge, {-0.5, 0, -3}, {0.5, 0, 30}, "label")};
  const SpaceScene scene(*renderer, stage, 0);
  EXPECT_EQ(scene.seen(stage.steps[0].items[0], {0, 0, 640, 400}).size(), 2U);
}

/// How many pixels of the slide's scene are of such a colour.
template <class Test>
int count(const Raster& slide, const Test& test, int right = 1020) {
  int count = 0;
  for (int y = 110; y < 700; ++y) {
    for (int x = 50; x < right; ++x) count += test(slide.at(x, y)) ? 1 : 0;
  }
  return count;
}

bool is_bluish(const Rgb& c) { return c[2] > c[0] + 25; }
bool is_black(const Rgb& c) { return c[0] < 40 && c[1] < 40 && c[2] < 48; }
bool is_dark_blue(const Rgb& c) { return c[0] < 50 && c[1] < 90 && c[2] > c[0] + 20; }

TEST(Slide, ShowsTheRayInTheBallThroughItsSurface) {
  const OffscreenDisplay display;
  const Stage stage = stage_of(*lessons_of("sphere").front(), report_lesson);
  PictureCanvas canvas;
  const Raster slide = draw_slide(canvas, stage, 0);
  EXPECT_EQ(slide.width, 1600);
  EXPECT_EQ(slide.height, 900);
  EXPECT_GT(count(slide, is_bluish), 50000);    // the ball
  EXPECT_GT(count(slide, is_black), 1000);      // the ray before it
  EXPECT_GT(count(slide, is_dark_blue), 1000);  // and in it
}

TEST(Slide, ShowsEveryShape) {
  const OffscreenDisplay display;
  PictureCanvas canvas;
  for (const std::string& type : ray_topics()) {
    const Stage stage = stage_of(report_lesson(with_shape(shapes_of(type).front()), ""));
    EXPECT_GT(count(draw_slide(canvas, stage, 0), is_bluish, 1550), 5000) << type;  // it has no numbers
  }
}

}  // namespace
