#pragma once
#include <string>

#include "bench/page/plot.hpp"

namespace rayproof::report {

/// One `<svg>` element: self-contained, in the page's colours (page_style.hpp), light or dark. Each mark
/// shows its figures when pointed at.
[[nodiscard]] std::string to_svg(const Plot& plot);

}  // namespace rayproof::report
