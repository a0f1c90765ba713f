#include <fmt/format.h>

#include <array>

#include "viz/flat/stage_picture.hpp"
#include "viz/scene/shown_items.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

/// A caption in the paragraphs in which it is best read: each equation in one of its own, or all of them in
/// one below the words, or all in one.
std::vector<std::string> paragraphs_of(const StageStep& step, int closeness) {
  const bool has_both = !step.words.empty() && step.caption.starts_with(step.words + " ");
  if (closeness == 2) return {step.caption};
  std::vector<std::string> paragraphs{step.caption};
  if (has_both) paragraphs = {step.words, step.caption.substr(step.words.size() + 1)};
  const bool is_split = closeness == 0 && !step.values.empty();
  for (std::size_t end = 0; is_split && (end = paragraphs.back().find("; ")) != std::string::npos;) {
    std::string rest = paragraphs.back().substr(end + 2);
    paragraphs.back().resize(end + 1);
    paragraphs.push_back(std::move(rest));
  }
  return paragraphs;
}

/// Below the scene, in letters of 24 pixels of a slide at least; what has no room there is left out.
void draw_caption(Picture& picture, const StageStep& step) {
  constexpr double width = slide_width - 2 * slide_margin;
  constexpr double leading = 1.3;
  const double top = slide_scene.bottom() + 22;
  double size = 16;
  std::vector<std::pair<Role, std::string>> lines;
  const auto fits = [&](double letters, int closeness) {
    size = letters;
    lines.clear();
    for (const std::string& paragraph : paragraphs_of(step, closeness))
      for (std::string& line : wrapped(paragraph, width, size))
        lines.emplace_back(Role::text, std::move(line));
    for (std::string& line : wrapped(step.digits, width, size)) {
      if (!line.empty()) lines.emplace_back(Role::muted, std::move(line));
    }
    return lines.size() <= static_cast<std::size_t>((slide_height - 32 - top) / (size * leading)) + 1;
  };
  constexpr double large = 16, small = 14.4;
  const bool is_whole = fits(large, 0) || fits(small, 0) || fits(large, 1) || fits(small, 1) ||
                        fits(large, 2) || fits(small, 2);
  if (!is_whole) {
    lines.resize(static_cast<std::size_t>((slide_height - 32 - top) / (size * leading)) + 1);
    lines.back().second += " …";
  }
  double y = top;
  for (const auto& [role, line] : lines) {
    add_text(picture, role, {slide_margin, y}, line, size);
    y += size * leading;
  }
}

/// In one line above what the slide is about, or in two in its place.
void draw_title(Picture& picture, const std::string& title, const std::string& second_line) {
  constexpr double size = 22, width = slide_width - 2 * slide_margin;
  const auto lines = wrapped(title, width, size * bold_width);
  if (lines.size() == 1) {
    add_text(picture, Role::text, {slide_margin, 34}, title, size, true);
    add_text(picture, Role::muted, {slide_margin, 54}, cut(second_line, 700, 13), 13);
    return;
  }
  add_text(picture, Role::text, {slide_margin, 27}, lines[0], size, true);
  add_text(picture, Role::text, {slide_margin, 53}, lines.size() > 2 ? lines[1] + "…" : lines[1], size, true);
}

}  // namespace

PixelBox slide_scene_of(const StageStep& step) {
  PixelBox scene = slide_scene;
  if (step.values.empty()) scene.width = slide_width - 2 * slide_margin;
  return scene;
}

std::vector<LegendEntry> legend_of(const Stage& stage, const std::vector<ShownItem>& shown) {
  const bool is_equation = std::holds_alternative<Quadratic<double>>(stage.one.question);
  struct Sign {
    Role role;
    const char* mark;  ///< the word on a point; of the others, the mark names itself by its label
    const char* line;  ///< on a line or surface; of the others, each names itself
  };
  const std::array<Sign, 8> signs{{{Role::ray, nullptr, is_equation ? "x axis" : "ray"},
                                   {Role::surface, nullptr, is_equation ? "the curve" : "surface"},
                                   {Role::edge, nullptr, "construction"},
                                   {Role::normal, nullptr, "normal"},
                                   {Role::nearest, "key point", nullptr},
                                   {Role::exact, "exact", nullptr},
                                   {Role::claimed, "as computed", nullptr},
                                   {Role::muted, nullptr, "earlier step"}}};
  std::vector<LegendEntry> legend;
  for (const Sign& sign : signs) {
    bool has_mark = false, has_line = false;
    for (const ShownItem& one : shown) {
      const bool is_named_area = one.item->form == Form::polygon && !one.item->label.empty();
      if (shown_role(one) == sign.role && !is_named_area)
        (one.item->form == Form::point ? has_mark : has_line) = true;
    }
    if (has_mark && sign.mark != nullptr) {
      legend.push_back({sign.role, true, sign.mark});
    } else if (has_line && sign.line != nullptr) {
      legend.push_back({sign.role, false, sign.line});
    }
  }
  return legend;
}

Element legend_sign(const LegendEntry& entry, const Point& at) {
  if (entry.is_mark) return Mark{entry.role, mark_of(entry.role), at};
  return PixelLine{entry.role, {{at.x - 9, at.y}, {at.x + 9, at.y}}, 2.6};
}

void draw_legend(Picture& picture, const Stage& stage, std::size_t step) {
  double x = slide_margin;
  const double y = slide_height - 16;
  for (const LegendEntry& entry : legend_of(stage, shown_in(stage, step))) {
    picture.elements.push_back(legend_sign(entry, {x + 6, y - 4}));
    add_text(picture, Role::muted, {x + 20, y}, entry.text, 12);
    x += 20 + text_width(entry.text, 12) + 18;
  }
}

Picture slide_frame(const Stage& stage, std::size_t number, const std::string& second_line,
                    const PixelBox& scene) {
  const StageStep& step = stage.steps.at(number);
  Picture picture{slide_width, slide_height, fmt::format("{}: {}", stage.title, step.title), step.caption};
  const std::string place = fmt::format("{} of {}", number + 1, stage.steps.size());
  const std::string title = fmt::format("{}. {}", number + 1, step.title);
  draw_title(picture, title, second_line);
  picture.elements.emplace_back(Text{Role::muted, {slide_width - slide_margin, 54}, place, Anchor::end, 14});
  if (step.is_apart && step.magnification != 1) {
    picture.elements.emplace_back(Text{Role::muted,
                                       {scene.left, scene.bottom() - 4},
                                       scale_in_words(enlargement(stage.steps.front(), step)),
                                       Anchor::start,
                                       13});
  }
  draw_values(picture, stage, step, scene);
  draw_caption(picture, step);
  return picture;
}

}  // namespace rayproof::viz
