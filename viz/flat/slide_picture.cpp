#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/flat/slide_values.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/scene/label_places.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

void draw_caption(Picture& picture, const StageStep& step) {
  const double width = slide_width - 2 * slide_margin;
  const double bottom = slide_height - 32;
  double y = slide_scene.bottom() + 22;
  const auto write = [&](Role role, const std::string& text, double size) {
    for (const std::string& line : wrapped(text, width, size)) {
      if (y > bottom) return;
      add_text(picture, role, {slide_margin, y}, line, size);
      y += size * 1.3;
    }
  };
  // The largest letters in which all of it has room.
  double size = 0;
  for (const double tried : {16.0, 14.4, 13.0}) {
    size = tried;
    const std::size_t lines = wrapped(step.caption, width, size).size() +
                              wrapped(step.digits, width, 14.4).size() - (step.digits.empty() ? 1 : 0);
    if (y + (static_cast<double>(lines) - 1) * size * 1.3 <= bottom) break;
  }
  write(Role::text, step.caption, size);
  if (!step.digits.empty()) write(Role::muted, step.digits, std::min(size, 14.4));
}

}  // namespace

std::vector<LegendEntry> legend_of(const Stage& stage) {
  static const std::vector<LegendEntry> all{
      {Role::ray, false, "ray"},
      {Role::surface, false, "surface"},
      {Role::edge, false, "edge, part"},
      {Role::normal, false, "normal"},
      {Role::nearest, true, "nearest, picked out"},
      {Role::exact, true, "exact hit"},
      {Role::claimed, true, "as computed"},
      {Role::muted, false, "earlier step"},
  };
  std::vector<LegendEntry> used;
  const auto is_used = [&](Role role) {
    const auto has = [&](const StageItem& item) { return item.role == role; };
    bool any = std::any_of(stage.scene.begin(), stage.scene.end(), has);
    for (const StageStep& step : stage.steps)
      any = any || std::any_of(step.items.begin(), step.items.end(), has);
    return any;
  };
  for (const LegendEntry& entry : all) {
    if (entry.role == Role::muted || is_used(entry.role)) used.push_back(entry);
  }
  return used;
}

Element legend_sign(const LegendEntry& entry, const Point& at) {
  if (entry.is_mark) return Mark{entry.role, mark_of(entry.role), at};
  return PixelLine{entry.role, {{at.x - 9, at.y}, {at.x + 9, at.y}}, 2.6};
}

void draw_legend(Picture& picture, const Stage& stage) {
  double x = slide_margin;
  const double y = slide_height - 16;
  for (const LegendEntry& entry : legend_of(stage)) {
    picture.elements.push_back(legend_sign(entry, {x + 6, y - 4}));
    add_text(picture, Role::muted, {x + 20, y}, entry.text, 12);
    x += 20 + text_width(entry.text, 12) + 18;
  }
}

Picture slide_frame(const Stage& stage, std::size_t number, const std::string& second_line,
                    const PixelBox& scene) {
  const StageStep& step = stage.steps.at(number);
  Picture picture;
  picture.width = slide_width;
  picture.height = slide_height;
  picture.title = fmt::format("{}: {}", stage.title, step.title);
  picture.description = step.caption;
  const std::string place = fmt::format("{} of {}", number + 1, stage.steps.size());
  const std::string title = fmt::format("{}. {}", number + 1, step.title);
  const double title_size = std::clamp(22 * 800 / text_width(title, 22, true), 14.0, 22.0);
  add_text(picture, Role::text, {slide_margin, 34}, title, title_size, true);
  add_text(picture, Role::muted, {slide_margin, 54}, cut(second_line, 700, 13), 13);
  picture.elements.emplace_back(Text{Role::muted, {slide_width - slide_margin, 34}, place, Anchor::end, 14});
  if (step.is_apart && step.magnification != 1) {
    picture.elements.emplace_back(Text{Role::muted,
                                       {scene.left, scene.bottom() - 4},
                                       scale_in_words(step.magnification),
                                       Anchor::start,
                                       13});
  }
  draw_values(picture, stage, step, scene);
  draw_caption(picture, step);
  return picture;
}

}  // namespace rayproof::viz
