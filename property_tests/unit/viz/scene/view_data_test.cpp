/// \file
/// What can be read of a step, whoever draws it: places and sizes of labels, room for the caption.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/viz/stage_data.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/picture/picture.hpp"
#include "viz/scene/items.hpp"
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
std::vector<Point> seen(const StageItem& item, const StageStep& step, const StageCamera& camera) {
  std::vector<Point> points;
  if (item.form == Form::ellipsoid) return points;
  const PixelBox scene = slide_scene_of(step);
  const double scale = scene.height / 2 / (1.1 * step.view.radius);
  for (const glm::dvec3& p : item.points) {
    const glm::dvec3 off = p - step.view.centre;
    points.push_back({scene.centre().x + scale * glm::dot(off, camera.right),
                      scene.centre().y - scale * glm::dot(off, camera.up)});
  }
  return points;
}

bool overlap(const PixelBox& a, const PixelBox& b) {
  return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

std::vector<Text> texts_of(const Picture& picture) {
  std::vector<Text> texts;
  for (const Element& element : picture.elements) {
    if (const auto* text = std::get_if<Text>(&element)) texts.push_back(*text);
  }
  return texts;
}

Picture frame_of(const Stage& stage, std::size_t step) {
  Picture picture = slide_frame(stage, step, stage.title, slide_scene_of(stage.steps[step]));
  draw_legend(picture, stage, step);
  return picture;
}

/// The labels of a step, in a slide where its other texts stand already.
std::vector<Text> labels_of(const Stage& stage, std::size_t step, const StageCamera& camera) {
  Picture picture = frame_of(stage, step);
  const std::size_t others = texts_of(picture).size();
  draw_labels(picture, slide_scene_of(stage.steps[step]), shown_in(stage, step),
              [&](const StageItem& item) { return seen(item, stage.steps[step], camera); });
  std::vector<Text> texts = texts_of(picture);
  texts.erase(texts.begin(), texts.begin() + static_cast<std::ptrdiff_t>(others));
  return texts;
}

void expect_apart(const std::vector<Text>& texts, const std::vector<Text>& others = {}) {
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const PixelBox box = box_of(texts[i]);
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(overlap(box, box_of(texts[k]))) << texts[i].text << " and " << texts[k].text;
    for (const Text& other : others)
      EXPECT_FALSE(overlap(box, box_of(other))) << texts[i].text << " and " << other.text;
  }
}

TEST(ViewData, NoLabelCoversAnotherOrATextOrLeavesTheFrameFromThreeSides) {
  std::size_t count = 0;
  for (const Lesson& lesson : lessons()) {
    const Stage stage = stage_of(lesson, report_lesson);
    for (std::size_t step = 0; step < stage.steps.size(); ++step) {
      const std::vector<Text> others = texts_of(frame_of(stage, step));
      const PixelBox scene = slide_scene_of(stage.steps[step]);
      for (const double angle : {0.0, 0.6, -0.9}) {
        const std::vector<Text> labels = labels_of(stage, step, turned(stage.camera, angle));
        SCOPED_TRACE(lesson.name + ": " + stage.steps[step].title + " from " + std::to_string(angle));
        count += labels.size();
        expect_apart(labels, others);
        for (const Text& label : labels) {
          const PixelBox box = box_of(label);
          EXPECT_GE(label.size * pixels_of_a_slide, 24 - 1e-9) << label.text;
          EXPECT_TRUE(scene.holds({box.left + 1, box.top + 1}) &&
                      scene.holds({box.right() - 1, box.bottom() - 1}))
              << label.text;
        }
      }
    }
  }
  EXPECT_GT(count, 2000U);
}

/// The lines that a step draws, as they are seen: of surfaces the edges.
std::vector<std::vector<Point>> lines_of(const Stage& stage, std::size_t step, const StageCamera& camera) {
  std::vector<std::vector<Point>> lines;
  for (const ShownItem& shown : shown_in(stage, step)) {
    const StageItem& item = *shown.item;
    if (item.form == Form::point || item.form == Form::ellipsoid || item.is_open) continue;
    if (item.role == Role::frame || item.faces.size() > 12) continue;
    const std::vector<Point> corners = seen(item, stage.steps[step], camera);
    if (item.form != Form::solid) lines.push_back(corners);
    if (item.form == Form::polygon) lines.back().push_back(corners.front());
    for (const std::vector<std::size_t>& face : item.faces) {
      lines.emplace_back();
      for (const std::size_t i : face) lines.back().push_back(corners[i]);
      lines.back().push_back(corners[face.front()]);
    }
  }
  return lines;
}

/// How many pixels of the lines a label covers.
double covered_by(const Text& label, const std::vector<std::vector<Point>>& lines) {
  double length = 0;
  for (const std::vector<Point>& line : lines) {
    for (const std::vector<Point>& part : clip_line(line, box_of(label)))
      for (std::size_t i = 1; i < part.size(); ++i)
        length += std::hypot(part[i].x - part[i - 1].x, part[i].y - part[i - 1].y);
  }
  return length;
}

TEST(ViewData, FewLabelsCoverALineAndNoneOfAnEarlierStep) {
  int count = 0, covering = 0;
  for (const Lesson& lesson : lessons()) {
    const Stage stage = stage_of(lesson, report_lesson);
    for (std::size_t step = 0; step < stage.steps.size(); ++step) {
      const auto lines = lines_of(stage, step, stage.camera);
      for (const Text& label : labels_of(stage, step, stage.camera)) {
        const double covered = covered_by(label, lines);
        ++count;
        if (covered > label.size) ++covering;
        if (label.role == Role::muted) {
          EXPECT_LT(covered, 3 * label.size)
              << lesson.name << ": " << stage.steps[step].title << ": " << label.text;
        }
      }
    }
  }
  EXPECT_LT(covering, 0.05 * count) << count;
}

TEST(ViewData, WithoutNumbersTheSceneHasTheWholeWidth) {
  for (const Lesson& lesson : lessons()) {
    for (const StageStep& step : stage_of(lesson, report_lesson).steps) {
      const double right = slide_scene_of(step).right();
      EXPECT_EQ(right, step.values.empty() ? slide_width - slide_margin : slide_scene.right())
          << lesson.name << ": " << step.title;
    }
  }
}

bool is_title(const Text& text) { return text.bold && text.at.y < slide_scene.top; }
bool is_of_caption(const Text& text) {
  return text.at.y > slide_scene.bottom() + 10 && text.at.y < slide_height - 20;
}

/// Titles, captions, values and the legend: large enough, whole, apart and on the slide.
void expect_legible(const Stage& stage, std::size_t step, const std::vector<Text>& texts) {
  std::string title, caption;
  for (const Text& text : texts) {
    const double least = is_title(text) ? 36 : is_of_caption(text) ? 24 : 20;
    EXPECT_GE(text.size * pixels_of_a_slide, least - 1e-9) << text.text;
    const PixelBox box = box_of(text);
    EXPECT_TRUE(box.left >= 0 && box.right() <= slide_width && box.top >= 0 && box.bottom() <= slide_height)
        << text.text;
    if (is_title(text)) title += (title.empty() ? "" : " ") + text.text;
    if (is_of_caption(text)) caption += (caption.empty() ? "" : " ") + text.text;
  }
  const StageStep& shown = stage.steps[step];
  EXPECT_EQ(title, typeset(std::to_string(step + 1) + ". " + shown.title));
  EXPECT_EQ(caption, typeset(shown.caption + (shown.digits.empty() ? "" : " " + shown.digits)));
  expect_apart(texts);
}

TEST(ViewData, TitlesCaptionsAndValuesAreLargeEnoughWholeAndApart) {
  for (const Lesson& lesson : lessons()) {
    const Stage stage = stage_of(lesson, report_lesson);
    for (std::size_t step = 0; step < stage.steps.size(); ++step) {
      SCOPED_TRACE(lesson.name + ": " + stage.steps[step].title);
      expect_legible(stage, step, texts_of(frame_of(stage, step)));
    }
  }
}

/// A step with this many vectors, of 17 digits each.
Stage stage_of_vectors(int count) {
  WalkValue component;
  component.value = -0.12345678901234567;
  component.exact = "-0.123456789012";
  component.bits_lost = 9;
  component.digits = 53;
  Stage stage;
  stage.precision = Precision::float64;
  stage.steps.emplace_back();
  for (int i = 0; i < count; ++i)
    stage.steps[0].values.push_back({"v" + std::to_string(i), read_formula("a − b"), {}, {3, component}});
  return stage;
}

TEST(ViewData, ManyVectorsStayInTheirPanelInLargeLetters) {
  const PixelBox low{slide_scene.left, slide_scene.top, slide_scene.width, 290};
  for (const PixelBox& scene : {slide_scene, low}) {
    for (const int count : {1, 3, 6, 9, 30}) {
      const Stage stage = stage_of_vectors(count);
      std::vector<Text> texts = texts_of(slide_frame(stage, 0, "", scene));
      std::erase_if(texts,
                    [&](const Text& text) { return text.at.x < scene.right() || text.at.y < scene.top; });
      EXPECT_GE(texts.size(), static_cast<std::size_t>(std::min(count, 6)));
      for (const Text& text : texts) {
        EXPECT_GE(text.size * pixels_of_a_slide, 20 - 1e-9) << text.text;
        EXPECT_LE(box_of(text).bottom(), scene.bottom() + 2) << count << ": " << text.text;
        EXPECT_LE(box_of(text).right(), slide_width) << text.text;
      }
      expect_apart(texts);
    }
  }
}

TEST(ViewData, TheLegendNamesWhatTheSlideShowsAndNothingElse) {
  const Stage stage = stage_of(*lessons_of("sphere").front(), report_lesson);
  const auto words = [&](std::size_t step) {
    std::string all;
    for (const LegendEntry& entry : legend_of(stage, shown_in(stage, step)))
      all += std::string(entry.text) + ";";
    return all;
  };
  EXPECT_EQ(words(0), "ray;surface;");
  EXPECT_EQ(words(1), "ray;surface;construction;");
  EXPECT_EQ(words(stage.steps.size() - 1), "ray;surface;exact;as computed;");
}

TEST(ViewData, ALabelHasAHalo) {
  const Stage stage = stage_of(*lessons_of("sphere").front(), report_lesson);
  for (const Text& label : labels_of(stage, 5, stage.camera)) EXPECT_TRUE(label.halo) << label.text;
}

}  // namespace
}  // namespace rayproof::viz
