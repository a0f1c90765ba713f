#include "viz/picture/picture.hpp"

#include <fmt/format.h>

#include <cctype>

#include "case/escape.hpp"

namespace rayproof::viz {

namespace {

std::string css_class(Role role) { return colour_of(role).name; }

std::string path(const std::vector<Point>& points) {
  std::string text;
  for (const Point& p : points) text += fmt::format("{}{:.2f} {:.2f}", text.empty() ? "M" : "L", p.x, p.y);
  return text;
}

std::string draw(const Area& area) {
  std::string rings;
  for (const std::vector<Point>& ring : area.rings) rings += path(ring) + "Z";
  return fmt::format("<path class=\"a {}\" fill-rule=\"evenodd\" d=\"{}\"/>\n", css_class(area.role), rings);
}

std::string draw(const PixelLine& line) {
  const char* dashes = line.pattern == Pattern::solid ? ""
                       : line.pattern == Pattern::dashed
                           ? " stroke-dasharray=\"7 5\""
                           : " stroke-dasharray=\"1.5 5\" stroke-linecap=\"round\"";
  return fmt::format("<path class=\"l {}\" stroke-width=\"{}\"{} d=\"{}\"/>\n", css_class(line.role),
                     line.width, dashes, path(line.points));
}

std::string draw(const Mark& mark) {
  const double x = mark.at.x;
  const double y = mark.at.y;
  const double r = mark_radius;
  const std::string role = css_class(mark.role);
  switch (mark.shape) {
    case MarkShape::dot:
      return fmt::format("<circle class=\"f {}\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"4.5\"/>\n", role, x, y);
    case MarkShape::ring:
      return fmt::format(
          "<circle class=\"l {}\" stroke-width=\"2.5\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\"/>\n", role, x, y,
          r);
    case MarkShape::cross:
      return fmt::format(
          "<path class=\"l {}\" stroke-width=\"2.5\" d=\"M{:.2f} {:.2f}l{} {}m0 {}l{} {}\"/>\n", role, x - r,
          y - r, 2 * r, 2 * r, -2 * r, -2 * r, 2 * r);
    case MarkShape::diamond:
      return fmt::format("<path class=\"f {}\" d=\"M{:.2f} {:.2f}l{} {}l{} {}l{} {}Z\"/>\n", role, x - r, y,
                         r, r, r, -r, -r, -r);
  }
  return {};
}

/// Each run after the first stands lower or higher than the one before it.
std::string spans_of(const Text& text) {
  const std::vector<TextRun> runs = runs_of(text.text);
  std::string spans = escaped(runs[0].text);
  const double drop = low_drop * text.size;
  for (std::size_t i = 1; i < runs.size(); ++i) {
    spans +=
        fmt::format("<tspan dy=\"{:.2f}\" font-size=\"{:.4g}\">{}</tspan>", runs[i].is_low ? drop : -drop,
                    (runs[i].is_low ? low_size : 1) * text.size, escaped(runs[i].text));
  }
  return spans;
}

std::string draw(const Text& text) {
  static constexpr const char* anchors[] = {"start", "middle", "end"};
  return fmt::format(
      "<text class=\"f {}{}\" x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{}\" text-anchor=\"{}\"{}>{}</text>\n",
      css_class(text.role), text.halo ? " h" : "", text.at.x, text.at.y, text.size,
      anchors[static_cast<std::size_t>(text.anchor)], text.bold ? " font-weight=\"bold\"" : "",
      spans_of(text));
}

/// Every rule begins with the picture's own class: a page's other styles are left alone.
std::string style() {
  return ".rayproof-picture{font-family:'DejaVu Sans',system-ui,sans-serif;max-width:100%;height:auto}" +
         role_style(".rayproof-picture");
}

/// A Latin letter, a digit, or a byte of a Greek letter.
bool is_letter(const std::string& text, std::size_t i) {
  if (i >= text.size()) return false;
  const auto byte = static_cast<unsigned char>(text[i]);
  const bool continues = (byte & 0xC0U) == 0x80U && i > 0;
  const auto lead = static_cast<unsigned char>(continues ? text[i - 1] : text[i]);
  return std::isalnum(byte) != 0 || lead == 0xCE || lead == 0xCF;
}

/// Where the index ends that begins after the "_" at `low`; `low` where there is none. "cross_side" and the
/// method "sphere/half_b" have none.
std::size_t end_of_index(const std::string& line, std::size_t low) {
  std::size_t begin = low, end = low + 1;
  while (begin > 0 && is_letter(line, begin - 1)) --begin;
  while (is_letter(line, end)) ++end;
  const bool is_alone = (begin == 0 || (line[begin - 1] != '_' && line[begin - 1] != '/')) &&
                        (end == line.size() || line[end] != '_');
  const std::size_t before = low - begin, after = end - low - 1;
  const bool is_name = before > 0 && after > 0 && (before <= 2 || after == 1);
  return is_alone && is_name ? end : low;
}

}  // namespace

std::string role_style(const std::string& scope) {
  const auto colours = [&](const char* RoleColour::*shade) {
    std::string rules =
        fmt::format("{} .h{{paint-order:stroke;stroke:{};stroke-width:4px;stroke-linejoin:round}}", scope,
                    colour_of(Role::background).*shade);
    for (const RoleColour& colour : palette)
      rules += fmt::format("{} .{}{{color:{}}}", scope, colour.name, colour.*shade);
    return rules;
  };
  return fmt::format(
      "{0} .l{{fill:none;stroke:currentColor}}{0} .f{{fill:currentColor}}"
      "{0} .a{{fill:currentColor;fill-opacity:{1}}}{2}@media screen and (prefers-color-scheme:dark){{{3}}}",
      scope, area_opacity, colours(&RoleColour::light), colours(&RoleColour::dark));
}

std::string to_svg(const Element& element) {
  return std::visit([](const auto& one) { return draw(one); }, element);
}

std::string to_svg(const Picture& picture) {
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"rayproof-picture\" role=\"img\" viewBox=\"0 0 {0} "
      "{1}\" "
      "width=\"{0}\" height=\"{1}\">\n<title>{2}</title>\n<desc>{3}</desc>\n<style>{4}</style>\n"
      "<rect class=\"f background\" width=\"{0}\" height=\"{1}\"/>\n",
      picture.width, picture.height, escaped(picture.title), escaped(picture.description), style());
  for (const Element& element : picture.elements) svg += to_svg(element);
  return svg + "</svg>\n";
}

std::vector<TextRun> runs_of(const std::string& line) {
  std::vector<TextRun> runs{{}};
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::size_t end = line[i] == '_' ? end_of_index(line, i) : i;
    if (end == i) {
      runs.back().text += line[i];
      continue;
    }
    runs.push_back({line.substr(i + 1, end - i - 1), true});
    if (end < line.size()) runs.emplace_back();
    i = end - 1;
  }
  return runs;
}

}  // namespace rayproof::viz
