#include "viz/scene/shown_items.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "viz/picture/picture.hpp"

namespace rayproof::viz {
namespace {

/// The code point that begins at text[i], and its length in bytes.
std::pair<char32_t, std::size_t> code_point(const std::string& text, std::size_t i) {
  const auto lead = static_cast<unsigned char>(text[i]);
  const std::size_t length = lead < 0x80 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  char32_t point = length == 1 ? lead : lead & (0xffU >> (length + 1));
  for (std::size_t k = 1; k < length && i + k < text.size(); ++k) {
    point = (point << 6U) | (static_cast<unsigned char>(text[i + k]) & 0x3fU);
  }
  return {point, length};
}

/// In em: DejaVu Sans's own widths, by groups of letters, the widest of each group.
double width_of(char32_t point) {
  if ((point >= 0x0300 && point <= 0x036f) || (point >= 0x20d0 && point <= 0x20ff)) return 0;
  const bool is_index = (point >= 0x2070 && point <= 0x209f) || point == U'²' || point == U'³';
  if (is_index) return 0.41;
  static const std::array<std::pair<std::u32string_view, double>, 6> groups{{{U"ijlIJ'′", 0.3},
                                                                             {U" ,.·:;/|-", 0.37},
                                                                             {U"()[]frt!", 0.42},
                                                                             {U"sczk*_°–FL", 0.59},
                                                                             {U"w+−=<>≤≥≠×→∞", 0.84},
                                                                             {U"mMW—…@%", 1}}};
  for (const auto& [letters, width] : groups)
    if (letters.find(point) != std::u32string_view::npos) return width;
  return point >= U'A' && point <= U'Z' ? 0.79 : 0.64;
}

double shared_area(const PixelBox& a, const PixelBox& b) {
  const double x = std::min(a.right(), b.right()) - std::max(a.left, b.left);
  const double y = std::min(a.bottom(), b.bottom()) - std::max(a.top, b.top);
  return x > 0 && y > 0 ? x * y : 0;
}

PixelBox box_around(const Point& middle, const std::string& label, double size) {
  const double width = text_width(label, size, true) + 4;
  const double height = size * 1.15;
  return {middle.x - width / 2, middle.y - height / 2, width, height};
}

}  // namespace

double text_width(const std::string& text, double size, bool bold) {
  double width = 0;
  for (const TextRun& run : runs_of(text)) {
    for (std::size_t i = 0; i < run.text.size();) {
      const auto [point, length] = code_point(run.text, i);
      width += width_of(point) * (run.is_low ? low_size : 1);
      i += length;
    }
  }
  return width * size * (bold ? bold_width : 1);
}

PixelBox box_of(const Text& text) {
  const double width = text_width(text.text, text.size, text.bold);
  const double part = text.anchor == Anchor::start ? 0 : text.anchor == Anchor::middle ? 0.5 : 1;
  return {text.at.x - part * width, text.at.y - 0.75 * text.size, width, 0.95 * text.size};
}

std::vector<std::string> wrapped(const std::string& text, double width, double size) {
  std::vector<std::string> lines{""};
  std::string word;
  const auto finish_word = [&] {
    if (word.empty()) return;
    std::string& line = lines.back();
    const std::string longer = line.empty() ? word : line + " " + word;
    if (text_width(longer, size) <= width || line.empty()) {
      line = longer;
    } else {
      lines.push_back(word);
    }
    word.clear();
  };
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = code_point(text, i).second;
    if (text[i] == ' ') {
      finish_word();
    } else {
      const std::string letter = text.substr(i, length);
      if (text_width(word + letter, size) > width) finish_word();
      word += letter;
    }
    i += length;
  }
  finish_word();
  return lines;
}

void LabelPlaces::take(const Point& at, double radius) {
  taken_.push_back({at.x - radius, at.y - radius, 2 * radius, 2 * radius});
}

void LabelPlaces::avoid(const std::vector<Point>& line, double cost) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double length = std::hypot(line[i + 1].x - line[i].x, line[i + 1].y - line[i].y);
    const int pieces = std::clamp(static_cast<int>(length / 5), 1, 400);
    for (int k = 0; k <= pieces; ++k) {
      const double part = static_cast<double>(k) / pieces;
      avoided_.push_back(
          {{line[i].x + part * (line[i + 1].x - line[i].x), line[i].y + part * (line[i + 1].y - line[i].y)},
           cost});
    }
  }
}

double LabelPlaces::cost_of(const PixelBox& box, double most) const {
  constexpr double half_line = 2;  // the lines that are avoided have a width
  const PixelBox wide{box.left - half_line, box.top - half_line, box.width + 2 * half_line,
                      box.height + 2 * half_line};
  double cost = 20 * (box.width * box.height - shared_area(box, frame_));  // outside of the frame
  for (const PixelBox& other : taken_) cost += 10 * shared_area(box, other);
  for (auto one = avoided_.begin(); one != avoided_.end() && cost < most; ++one)
    cost += wide.holds(one->at) ? one->cost : 0;
  return cost;
}

Text LabelPlaces::take(const PixelBox& box, const std::string& label, double size) {
  taken_.push_back(box);
  return {Role::text, {box.centre().x, box.bottom() - size * 0.27}, label, Anchor::middle, size, true, true};
}

Text LabelPlaces::put_at(const std::string& label, const Point& middle, double size) {
  const PixelBox own = box_around(middle, label, size);
  // A label too long for its place moves into the frame as far as it can.
  const double least = frame_.left + own.width / 2;
  const double most = std::max(least, frame_.right() - own.width / 2);
  return take(box_around({std::clamp(middle.x, least, most), middle.y}, label, size), label, size);
}

std::optional<Text> LabelPlaces::put(const std::string& label, const std::vector<Point>& anchors, double size,
                                     double most) {
  const PixelBox own = box_around({0, 0}, label, size);
  PixelBox best{};
  double least = std::numeric_limits<double>::infinity(), covered = 0;
  for (std::size_t k = 0; k < anchors.size(); ++k) {
    for (const double away : {13.0, 22.0, 34.0, 48.0, 64.0}) {
      for (int i = 0; i < 16; ++i) {
        // Beginning above at the right, where a reader looks for it first.
        const double angle = std::numbers::pi * (0.25 + i / 8.0);
        const Point middle{anchors[k].x + (away + own.width / 2) * std::cos(angle),
                           anchors[k].y - (away + own.height / 4) * std::sin(angle)};
        const PixelBox box = box_around(middle, label, size);
        const double penalty = away * 1.5 + i * 0.4 + static_cast<double>(k) * 5;
        const double cost = cost_of(box, least - penalty);
        if (penalty + cost >= least) continue;
        least = penalty + cost;
        covered = cost;
        best = box;
      }
    }
  }
  if (covered > most) return std::nullopt;
  return take(best, label, size);
}

}  // namespace rayproof::viz
