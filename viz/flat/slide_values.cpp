#include "viz/flat/stage_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "viz/scene/shown_items.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/trace/record.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

constexpr double value_column = 634;
constexpr double value_width = slide_width - slide_margin - value_column;

/// A line of the column of values: a name with its formula, more of that, or a number and in grey before it
/// what it is.
struct ValueLine {
  Role role = Role::text;
  bool is_name = false;
  const char* what = "";
  std::string text{};
};

/// How much of a value is written: all of it; the exact number and the bits lost only where they are worth a
/// word; no more of the formula than has room in a line; the name and the rounded number in one line.
enum class Detail { full, noteworthy, brief, terse };

constexpr double name_size = 14, number_size = 13, word_size = 12;
constexpr double number_left = value_column + 62;
/// Between baselines, and more above a name.
constexpr double most_row = 19, least_row = 16, above_name = 5;

std::vector<ValueLine> lines_of(const StageValue& value, const Stage& stage, Detail detail) {
  const bool is_float = stage.precision == Precision::float32;
  std::vector<ValueLine> lines;
  const auto add = [&](Role role, const char* what, const std::string& text, double width) {
    for (const std::string& line : wrapped(text, width, number_size)) {
      lines.push_back({role, false, what, line});
      what = "";
    }
  };
  constexpr double width = value_column + value_width - number_left;
  const std::string rounded = shown(value, stage.precision);
  if (detail == Detail::terse) {
    add(Role::claimed, "", value.name + " = " + rounded, width);
    lines.front().is_name = true;
    return lines;
  }
  const std::string formula = formula_beside_name(value);
  const std::string head = value.name + (formula.empty() ? "" : " = " + formula);
  const auto heads = wrapped(head, value_width, name_size * bold_width);
  const bool is_whole = detail < Detail::brief && heads.size() < 4;
  lines.push_back(
      {Role::text, true, "", is_whole ? heads[0] : cut(head, value_width, name_size * bold_width)});
  for (std::size_t i = 1; is_whole && i < heads.size(); ++i)
    lines.push_back({Role::text, false, "", heads[i]});
  add(Role::claimed, is_float ? "float" : "double", rounded, width);
  const WalkValue& worst = worst_component(value);
  if (worst.bits_lost < (detail == Detail::full ? 0.05 : noteworthy)) return lines;
  add(Role::exact, "exact", exact_of(value), width);
  add(Role::muted, "lost", fmt::format("{:.1f} of {} bits", worst.bits_lost, worst.digits), width);
  return lines;
}

/// How high they are in the closest rows.
double height_of(const std::vector<ValueLine>& lines, double row) {
  const auto names = std::ranges::count_if(lines, [](const ValueLine& one) { return one.is_name; });
  return static_cast<double>(lines.size()) * row + static_cast<double>(names) * above_name;
}

/// All lines, in as much detail as there is room for; what has no room in the least is counted.
std::vector<ValueLine> lines_in(double room, const Stage& stage, const StageStep& step) {
  std::vector<ValueLine> lines;
  for (const Detail detail : {Detail::full, Detail::noteworthy, Detail::brief, Detail::terse}) {
    lines.clear();
    for (const StageValue& value : step.values)
      for (ValueLine& line : lines_of(value, stage, detail)) lines.push_back(std::move(line));
    if (height_of(lines, least_row) <= room) return lines;
  }
  std::size_t left_out = 0;
  bool is_whole = true;
  while (!lines.empty() && (!is_whole || height_of(lines, least_row) > room - least_row)) {
    is_whole = lines.back().is_name;
    left_out += is_whole ? 1 : 0;
    lines.pop_back();
  }
  lines.push_back({Role::muted, true, "", fmt::format("and {} more", left_out)});
  return lines;
}

}  // namespace

std::string cut(const std::string& text, double width, double size) {
  if (wrapped(text, width, size).size() < 2) return text;
  return wrapped(text, width - size, size).front() + "…";
}

void draw_values(Picture& picture, const Stage& stage, const StageStep& step, const PixelBox& scene) {
  const std::vector<ValueLine> lines = lines_in(scene.height, stage, step);
  if (lines.empty()) return;
  const double gaps = height_of(lines, 0);
  const double row =
      std::clamp((scene.height - gaps) / static_cast<double>(lines.size()), least_row, most_row);
  double y = scene.top + 14 - above_name;
  for (const ValueLine& line : lines) {
    if (line.is_name) y += above_name;
    const bool is_head = line.role == Role::text;
    if (*line.what != '\0') add_text(picture, Role::muted, {value_column + 8, y}, line.what, word_size);
    const double left = line.is_name ? value_column : is_head ? value_column + 8 : number_left;
    add_text(picture, line.role, {left, y}, line.text, is_head ? name_size : number_size, is_head);
    y += row;
  }
}

}  // namespace rayproof::viz
