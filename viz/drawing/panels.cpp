#include "viz/drawing/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/explain/answers.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

/// At most this many characters, the last of them an ellipsis where some are left out.
std::string shortened(const std::string& text, std::size_t most) {
  std::size_t characters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_start = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
    if (is_start && ++characters == most) return text.substr(0, i) + "…";
  }
  return text;
}

}  // namespace

Picture begin_picture(const std::string& what, const Case& one, const std::string& headline,
                      const std::string& geometry) {
  Picture picture;
  picture.title = headline;
  const std::string subject =
      fmt::format("{} in {}.{}{}", what, name_of(one.precision), one.note.empty() ? "" : " ", one.note);
  picture.description = subject + " " + geometry;
  const double size = headline.size() > 62 ? 17 : 20;  // a long one has to fit, too
  picture.elements.emplace_back(Text{Role::text, {20, 30}, headline, Anchor::start, size, true});
  picture.elements.emplace_back(Text{Role::muted, {20, 54}, shortened(subject, 110), Anchor::start, 13});
  picture.elements.emplace_back(Text{Role::muted, {20, 73}, geometry, Anchor::start, 13});
  return picture;
}

std::string magnification(const View& main, const View& inset) {
  const Shadow x = inset.scale_x / main.scale_x;
  const Shadow y = inset.scale_y / main.scale_y;
  if (inset.scale_x == inset.scale_y && main.scale_x == main.scale_y) {
    return scale_in_words(x);
  }
  return fmt::format("Magnified ×{} along, ×{} across", rough(x, 2), rough(y, 2));
}

void draw_focus(Picture& picture, const View& main, const View& inset) {
  constexpr double least = 9;
  const PixelBox& frame = main.frame;
  const Point at = main.to_pixels(inset.centre);
  const double half_x = std::max(least, static_cast<double>(inset.half_width() * main.scale_x));
  const double half_y = std::max(least, static_cast<double>(inset.half_height() * main.scale_y));
  const double left = std::max(at.x - half_x, frame.left + 1);
  const double right = std::min(at.x + half_x, frame.right() - 1);
  const double top = std::max(at.y - half_y, frame.top + 1);
  const double bottom = std::min(at.y + half_y, frame.bottom() - 1);
  if (left >= right || top >= bottom) return;
  picture.elements.emplace_back(
      PixelLine{Role::muted, {{left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top}}, 1.5});
  picture.elements.emplace_back(
      PixelLine{Role::frame, {{right, top}, {inset.frame.left, inset.frame.top}}, 1, Pattern::dotted});
  picture.elements.emplace_back(PixelLine{
      Role::frame, {{right, bottom}, {inset.frame.left, inset.frame.bottom()}}, 1, Pattern::dotted});
}

void draw_measure(Picture& picture, const View& view, const std::pair<WorldPoint, WorldPoint>& ends,
                  const std::string& label) {
  Point a = view.to_pixels(ends.first);
  Point b = view.to_pixels(ends.second);
  const bool is_level = std::abs(a.y - b.y) < std::abs(a.x - b.x);
  const double tick = 5;
  const double aside = is_level ? 46 : 0;
  a.y -= aside;
  b.y -= aside;
  const double dx = is_level ? 0 : tick;
  const double dy = is_level ? tick : 0;
  picture.elements.emplace_back(PixelLine{
      Role::text,
      {{a.x - dx, a.y - dy}, {a.x + dx, a.y + dy}, a, b, {b.x - dx, b.y - dy}, {b.x + dx, b.y + dy}},
      1.5});
  const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
  picture.elements.emplace_back(
      is_level ? Text{Role::text, {middle.x, middle.y - 10}, label, Anchor::middle, 14, false, true}
               : Text{Role::text, {middle.x - 10, middle.y + 5}, label, Anchor::end, 14, false, true});
}

void finish_picture(Picture& picture, const Panels& panels, const std::string& symbol, const Case& one,
                    const Answer* exact, const Answer* claimed) {
  const double top = panels.whole.bottom() + 6;
  picture.height = top + draw_answer_table(picture, top, symbol, one, exact, claimed);
}

}  // namespace rayproof::viz
