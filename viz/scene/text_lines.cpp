#include <algorithm>
#include <array>
#include <string_view>

#include "viz/picture/picture.hpp"
#include "viz/scene/shown_items.hpp"

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

/// Whether a line may end at a space: not before a sign, nor behind one that compares; within a vector only
/// where that is wider than a line.
bool may_end_at(const std::string& text, std::size_t space, double width, double size) {
  static constexpr std::array<std::string_view, 9> signs{"<", ">", "≤", "≥", "=", "+", "−", "/", "×"};
  const std::string_view before = std::string_view(text).substr(0, space);
  const std::string_view behind = std::string_view(text).substr(space + 1);
  const auto is_next = [&](std::string_view sign) {
    return behind.starts_with(sign) && behind.substr(sign.size()).starts_with(' ');
  };
  const auto is_last = [&](std::string_view sign) { return before.ends_with(sign); };
  if (std::any_of(signs.begin(), signs.end(), is_next)) return false;
  if (std::any_of(signs.begin(), signs.begin() + 4, is_last)) return false;
  const std::size_t open = before.find_last_of("()"), close = text.find_first_of("()", space);
  if (open == std::string::npos || text[open] == ')' || close == std::string::npos || text[close] == '(')
    return true;
  const std::string inside = text.substr(open, close + 1 - open);
  return inside.find_first_not_of("(0123456789.,−-+e )") != std::string::npos ||
         text_width(inside, size) > width;
}

}  // namespace

std::string typeset(const std::string& text) {
  constexpr std::string_view before = " (,=|/^";
  std::string set;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_free = i == 0 || before.find(text[i - 1]) != std::string_view::npos || set.ends_with("·");
    const char next = i + 1 < text.size() ? text[i + 1] : ' ';
    const bool is_operator = next != ' ' || (i > 0 && text[i - 1] == ' ');
    if (text[i] == '-' && next != '-' && is_free && is_operator)
      set += "−";
    else
      set += text[i];
  }
  return set;
}

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

std::vector<std::string> wrapped(const std::string& plain, double width, double size) {
  const std::string text = typeset(plain);
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
    if (text[i] == ' ' && may_end_at(text, i, width, size)) {
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

}  // namespace rayproof::viz
