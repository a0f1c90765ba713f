#pragma once
/// \file
/// A picture as SVG text, without VTK: to be embedded in a page as it stands.

#include <string>

#include "viz/picture/picture.hpp"

namespace rayproof::viz {

/// One `<svg>` element. The text is self-contained (no font, script, style or address from elsewhere),
/// follows the reader's light or dark scheme, scales to the width of the element it is put into, and bears a
/// `<title>` and a `<desc>` for screen readers. As a file of its own, put xml_head before it.
[[nodiscard]] std::string to_svg(const Picture& picture);

/// An element alone, for an `<svg>` that is styled already.
[[nodiscard]] std::string to_svg(const Element& element);

/// How an element within `scope`, a CSS selector, is painted by its classes: l a line, f filled, a an area, h
/// a halo; and the colour of its role, in light and dark.
[[nodiscard]] std::string role_style(const std::string& scope);

inline constexpr const char* xml_head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

}  // namespace rayproof::viz
