#pragma once
#include "properties/report/page.hpp"

namespace rayproof {

/// A finding as an `<article>`: its number, what is wrong in words, the picture, got beside exact, the
/// commands, and the case.
[[nodiscard]] std::string html_finding(const Finding& finding, const PageTools& tools);

}  // namespace rayproof
