#include "viz/flat/stage_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/explain/case_report.hpp"
#include "viz/scene/shown_items.hpp"
#include "viz/scene/space.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
namespace {

constexpr double sheet_margin = 20;  ///< free at the left and right
constexpr double frames_top = 108;   ///< of the frames

std::string subject_of(const Case& one) {
  const auto* ray = std::get_if<RayQuestion>(&one.question);
  const std::string what = ray == nullptr   ? topic_of(one) == "quadratic" ? "Quadratic" : "Point and polygon"
                           : ray->transform ? "Ray and transformed " + topic_of(one)
                                            : "Ray and " + topic_of(one);
  return fmt::format("{} in {}{}{}.", what, name_of(one.precision), one.note.empty() ? "" : ": ", one.note);
}

/// Side by side: two in the proportions of a view; three are narrow, and higher, so that labels find room.
std::vector<PixelBox> frames_of(std::size_t count, double width) {
  const double each = (width - sheet_margin) / static_cast<double>(count) - sheet_margin;
  const double height = count == 1 ? 300 : count == 2 ? each / view_aspect : 230;
  std::vector<PixelBox> frames;
  for (std::size_t i = 0; i < count; ++i)
    frames.push_back(
        {sheet_margin + static_cast<double>(i) * (each + sheet_margin), frames_top, each, height});
  return frames;
}

double scale_of(const CaseSheet& sheet, std::size_t i) {
  const StageStep& step = sheet.stage.steps[i];
  return step.magnification * pixels_per_length(step.view, sheet.frames[i]);
}

void draw_frame(CaseSheet& sheet, std::size_t i) {
  const PixelBox& b = sheet.frames[i];
  add_frame(sheet.picture, Role::frame, b, 1);
  const StageStep& step = sheet.stage.steps[i];
  const std::string caption = step.is_apart ? scale_in_words(scale_of(sheet, i) / scale_of(sheet, 0))
                              : i > 0       ? step.title
                                            : "";
  add_text(sheet.picture, Role::muted, {b.left, b.top - 8}, caption, 13);
}

/// A bar of 1, 2 or 5 times a power of ten at the right above the frame, where no label is.
void draw_scale_bar(Picture& picture, const PixelBox& frame, double scale) {
  const double length = grid_step(frame.width / 3 / scale);
  if (!std::isnormal(length)) return;
  const double y = frame.top - 12, end = frame.right(), x = end - length * scale;
  picture.elements.emplace_back(
      PixelLine{Role::muted, {{x, y - 4}, {x, y + 4}, {x, y}, {end, y}, {end, y - 4}, {end, y + 4}}});
  picture.elements.emplace_back(
      Text{Role::muted, {x - 6, y + 4}, rough(length), Anchor::end, 12, false, true});
}

constexpr double table_row = 24, exact_column = 130, claimed_column = 400, apart_column = 660;

void draw_table_head(Picture& picture, double y, bool has_claim, bool has_pair) {
  picture.elements.emplace_back(Mark{Role::exact, MarkShape::ring, {exact_column + 8, y - 5}});
  add_text(picture, Role::exact, {exact_column + 22, y}, "exact, correctly rounded", 15, true);
  if (!has_claim) return;
  picture.elements.emplace_back(Mark{Role::claimed, MarkShape::cross, {claimed_column + 8, y - 5}});
  add_text(picture, Role::claimed, {claimed_column + 22, y}, "claimed", 15, true);
  if (has_pair) add_text(picture, Role::muted, {apart_column, y}, "apart", 15, true);
}

/// The answers' values under each other: name, exact, claimed, distance; a verdict where there are none.
/// Returns the height it took.
double draw_answer_table(Picture& picture, double top, const CaseReport& report) {
  const std::vector<double> truth = values_of(&report.exact), claim = values_of(report.claim());
  const Precision precision = report.one.precision;
  const bool has_names = !std::holds_alternative<PointAndPolygon<double>>(report.one.question);
  double y = top + table_row;
  draw_table_head(picture, y, report.claimed.has_value(), !truth.empty() && !claim.empty());
  const std::size_t count = std::max<std::size_t>({truth.size(), claim.size(), 1});
  for (std::size_t i = 0; i < count; ++i) {
    y += table_row;
    const auto cell = [&](Role role, double x, const std::vector<double>& list, const Answer* answer) {
      if (i < list.size()) return add_text(picture, role, {x, y}, shown(list[i], precision), 15);
      if (i == 0 && answer != nullptr) add_text(picture, role, {x, y}, verdict_of(answer), 15);
    };
    if (has_names) add_text(picture, Role::text, {56, y}, root_name(report, i), 15, true);
    cell(Role::exact, exact_column, truth, &report.exact);
    cell(Role::claimed, claimed_column, claim, report.claim());
    if (i < truth.size() && i < claim.size())
      add_text(picture, Role::text, {apart_column, y}, apart_in_words(truth[i], claim[i], precision), 15);
  }
  return y + table_row / 2 - top;
}

/// What the case is and what is wrong, and below it where the ray passes; both in two lines where the first
/// needs more than one.
void draw_subject(Picture& picture, const std::string& subject, const std::string& caption) {
  constexpr double size = 13;
  const double room = picture.width - 2 * sheet_margin;
  std::vector<std::string> lines{subject, caption};
  if (wrapped(subject, room, size).size() > 1) lines = wrapped(subject + " " + caption, room, size);
  if (lines.size() > 2) lines[1] += "…";
  for (std::size_t i = 0; i < 2; ++i)
    add_text(picture, Role::muted, {sheet_margin, i == 0 ? 54.0 : 73.0}, lines[i], size);
}

}  // namespace

CaseSheet case_sheet(const CaseReport& report) {
  CaseSheet sheet{case_views(report)};
  Picture& picture = sheet.picture;
  picture.width = 900;
  sheet.frames = frames_of(sheet.stage.steps.size(), picture.width);
  picture.title = headline_of(report.one, &report.exact, report.claim());
  const std::string subject = subject_of(report.one);
  picture.description = subject + " " + sheet.stage.steps.front().caption;
  add_text(picture, Role::text, {sheet_margin, 30}, picture.title, picture.title.size() > 62 ? 17 : 20, true);
  draw_subject(picture, subject, sheet.stage.steps.front().caption);
  for (std::size_t i = 0; i < sheet.frames.size(); ++i) draw_frame(sheet, i);
  const double bottom = sheet.frames.front().bottom() + 6;
  picture.height = bottom + draw_answer_table(picture, bottom, report);
  return sheet;
}

Picture case_picture(const CaseReport& report) {
  CaseSheet sheet = case_sheet(report);
  for (std::size_t i = 0; i < sheet.frames.size(); ++i) {
    draw_scene(sheet.picture, sheet.frames[i], sheet.stage, i);
    draw_scale_bar(sheet.picture, sheet.frames[i], scale_of(sheet, i));
  }
  return sheet.picture;
}

}  // namespace rayproof::viz
