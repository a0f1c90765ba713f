#pragma once
/// \file
/// A picture of a case as SVG text, without VTK: to be embedded in a page as it stands.

#include <string>

#include "case/answer.hpp"
#include "case/case.hpp"
#include "viz/picture/picture.hpp"

namespace rayproof::viz {

/// One `<svg>` element that shows the case with its exact answer and, where it is given, somebody's claimed
/// answer.
///
/// Either answer may be null: what is not given is not drawn. The text is self-contained (no font, script,
/// style or address from elsewhere), follows the reader's light or dark scheme, scales to the width of the
/// element it is put into, and bears a `<title>` and a `<desc>` for screen readers. Use, in a page:
///
///     page << "<figure>" << viz::svg_of(finding.one, &exact, &claimed) << "</figure>";
///
/// Never throws for a valid case, whatever the answers' numbers (NaN and infinities are given in words). A
/// topic that has no picture gives an `<svg>` that says so. As a file of its own, put xml_head before it.
[[nodiscard]] std::string svg_of(const Case& one, const Answer* exact, const Answer* claimed);

/// The same for any picture.
[[nodiscard]] std::string to_svg(const Picture& picture);

/// How an element within `scope`, a CSS selector, is painted by its classes: l a line, f filled, a an area, h
/// a halo; and the colour of its role, in light and dark.
[[nodiscard]] std::string role_style(const std::string& scope);

inline constexpr const char* xml_head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

}  // namespace rayproof::viz
