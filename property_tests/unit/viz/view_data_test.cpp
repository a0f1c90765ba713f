/// \file
/// What can be read of a step, whoever draws it: places and sizes of labels, room for the caption, contrast.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/viz/stage_data.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/picture/palette.hpp"
#include "viz/picture/raster.hpp"
#include "viz/scene/fit_view.hpp"
#include "viz/scene/label_places.hpp"
#include "viz/scene/shown_items.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
namespace {

/// Slides have 1600 pixels for 960 of a picture's.
constexpr double pixels_of_a_slide = 1600 / slide_width;

/// The stage's camera turned about its own up.
StageCamera turned(const StageCamera& camera, double angle) {
  if (camera.is_flat) return camera;
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * camera.right + s * camera.toward, camera.up, c * camera.toward - s * camera.right, false};
}

/// Where an item is seen in the scene's frame.
std::vector<Point> seen(const StageItem& item, const StageView& view, const StageCamera& camera) {
  std::vector<Point> points;
  if (item.form == Form::ellipsoid) return points;
  const double scale = slide_scene.height / 2 / (1.1 * view.radius);
  for (const glm::dvec3& p : item.points) {
    const glm::dvec3 off = p - view.centre;
    points.push_back({slide_scene.centre().x + scale * glm::dot(off, camera.right),
                      slide_scene.centre().y - scale * glm::dot(off, camera.up)});
  }
  return points;
}

PixelBox box_of(const Text& text) {
  const double width = text_width(text.text, text.size, text.bold);
  const double left = text.anchor == Anchor::middle ? text.at.x - width / 2
                      : text.anchor == Anchor::end  ? text.at.x - width
                                                    : text.at.x;
  return {left, text.at.y - 0.75 * text.size, width, 0.9 * text.size};
}

bool overlap(const PixelBox& a, const PixelBox& b) {
  return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

std::vector<Text> labels_of(const Stage& stage, std::size_t step, const StageCamera& camera) {
  Picture picture;
  draw_labels(picture, slide_scene, shown_in(stage, step),
              [&](const StageItem& item) { return seen(item, stage.steps[step].view, camera); });
  std::vector<Text> labels;
  for (const Element& element : picture.elements) {
    if (const auto* text = std::get_if<Text>(&element)) labels.push_back(*text);
  }
  return labels;
}

TEST(ViewData, NoLabelCoversAnotherOrLeavesTheFrameFromThreeSides) {
  std::size_t count = 0;
  for (const Lesson& lesson : lessons()) {
    const Stage stage = stage_of(lesson, report_lesson);
    for (std::size_t step = 0; step < stage.steps.size(); ++step) {
      for (const double angle : {0.0, 0.6, -0.9}) {
        const std::vector<Text> labels = labels_of(stage, step, turned(stage.camera, angle));
        SCOPED_TRACE(lesson.name + ": " + stage.steps[step].title + " from " + std::to_string(angle));
        for (std::size_t i = 0; i < labels.size(); ++i, ++count) {
          const PixelBox box = box_of(labels[i]);
          EXPECT_GE(labels[i].size * pixels_of_a_slide, 20) << labels[i].text;
          EXPECT_TRUE(slide_scene.holds({box.left + 1, box.top + 1}) &&
                      slide_scene.holds({box.right() - 1, box.bottom() - 1}))
              << labels[i].text;
          for (std::size_t k = 0; k < i; ++k)
            EXPECT_FALSE(overlap(box, box_of(labels[k]))) << labels[i].text << " and " << labels[k].text;
        }
      }
    }
  }
  EXPECT_GT(count, 2000U);
}

TEST(ViewData, ACaptionHasRoomBelowItsPicture) {
  for (const Lesson& lesson : lessons()) {
    const Stage stage = stage_of(lesson, report_lesson);
    for (const StageStep& step : stage.steps) {
      constexpr double size = 13, width = slide_width - 2 * slide_margin;
      const std::size_t lines = wrapped(step.caption, width, size).size() +
                                (step.digits.empty() ? 0 : wrapped(step.digits, width, size).size());
      EXPECT_LE(slide_scene.bottom() + 22 + (static_cast<double>(lines) - 1) * 1.3 * size, slide_height - 32)
          << lesson.name << ": " << step.title << ": " << step.caption;
    }
  }
}

double luminance(const Rgb& colour) {
  const auto linear = [](std::uint8_t value) {
    const double v = value / 255.0;
    return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
}

double contrast(const char* a, const char* b) {
  const double x = luminance(rgb_of(a)), y = luminance(rgb_of(b));
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

/// Labels bear a halo of the background's colour, whatever is behind them.
TEST(ViewData, EveryRoleThatALabelMayHaveContrastsWithItsHalo) {
  const RoleColour& background = colour_of(Role::background);
  for (const Role role : {Role::text, Role::muted, Role::surface, Role::ray, Role::exact, Role::claimed,
                          Role::nearest, Role::normal, Role::edge}) {
    EXPECT_GE(contrast(colour_of(role).light, background.light), 4.5) << colour_of(role).name;
    EXPECT_GE(contrast(colour_of(role).dark, background.dark), 4.5) << colour_of(role).name;
  }
}

TEST(ViewData, ALabelHasAHalo) {
  const Stage stage = stage_of(*lessons_of("sphere").front(), report_lesson);
  for (const Text& label : labels_of(stage, 5, stage.camera)) EXPECT_TRUE(label.halo) << label.text;
}

}  // namespace
}  // namespace rayproof::viz
