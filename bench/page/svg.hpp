#pragma once
/// \file
/// Words and lines of the report's SVG.

#include <fmt/format.h>

#include <string>

#include "case/escape.hpp"

namespace rayproof::report {

[[nodiscard]] inline std::string svg_text(double x, double y, const char* anchor, const std::string& words,
                                          const char* more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x, y, anchor, more,
                     escaped(words));
}

[[nodiscard]] inline std::string svg_line(double x0, double y0, double x1, double y1, const char* style) {
  return fmt::format("<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", style,
                     x0, y0, x1, y1);
}

}  // namespace rayproof::report
