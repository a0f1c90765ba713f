#include "viz/flat/slide_values.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "viz/scene/label_places.hpp"
#include "viz/trace/losses.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

constexpr double value_column = 634;
constexpr double value_width = slide_width - slide_margin - value_column;

/// A line of the column of values: a name, or a number and in grey before it what it is.
struct ValueLine {
  Role role = Role::text;
  bool is_name = false;
  const char* what = "";
  std::string text{};
};

/// Below each name the rounded number, the exact one, and the bits lost where they are worth a word. Where
/// there is little room, the last two only of numbers that have lost something of note.
std::vector<ValueLine> lines_of(const StageValue& value, const Stage& stage, bool is_short) {
  const bool is_float = stage.precision == Precision::float32;
  const std::string head = value.name + (has_formula(value) ? " = " + text_of(value.formula) : "");
  std::vector<ValueLine> lines{{Role::text, true, "", cut(head, value_width, 14)}};
  const auto add = [&](Role role, const char* what, const std::string& text) {
    for (const std::string& line : wrapped(text, value_width - 62, 13)) {
      lines.push_back({role, false, what, line});
      what = "";
    }
  };
  add(Role::claimed, is_float ? "float" : "double", shown(value, stage.precision));
  const WalkValue& worst = worst_component(value);
  if (worst.bits_lost < (is_short ? noteworthy : 0.05)) return lines;
  add(Role::exact, "exact", exact_of(value));
  add(Role::muted, "lost", fmt::format("{:.1f} of {} bits", worst.bits_lost, worst.digits));
  return lines;
}

}  // namespace

std::string cut(const std::string& text, double width, double size) {
  const auto lines = wrapped(text, width, size);
  return lines.size() < 2 ? text : lines.front() + "…";
}

void draw_values(Picture& picture, const Stage& stage, const StageStep& step, const PixelBox& scene) {
  std::vector<std::vector<ValueLine>> values;
  std::size_t count = 0;
  const double room = scene.height - 14 - 5 * static_cast<double>(step.values.size());
  for (const bool is_short : {false, true}) {
    values.clear();
    count = 0;
    for (const StageValue& value : step.values) {
      values.push_back(lines_of(value, stage, is_short));
      count += values.back().size();
    }
    if (static_cast<double>(count) * 17 <= room) break;
  }
  const double row = std::clamp(room / static_cast<double>(std::max<std::size_t>(count, 1)), 13.0, 19.0);
  double y = scene.top + 14;
  for (const auto& lines : values) {
    for (const ValueLine& line : lines) {
      if (*line.what != '\0') add_text(picture, Role::muted, {value_column + 8, y}, line.what, 12);
      add_text(picture, line.role, {line.is_name ? value_column : value_column + 62, y}, line.text,
               line.is_name ? 14 : 13, line.is_name);
      y += row;
    }
    y += 5;
  }
}

}  // namespace rayproof::viz
