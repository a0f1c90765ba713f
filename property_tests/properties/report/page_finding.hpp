#pragma once
#include "properties/report/page.hpp"

namespace rayproof {

/// A counterexample as an `<article>`: what broke, the picture, got beside exact, the case, and the commands.
[[nodiscard]] std::string html_finding(const Finding& finding, const DrawCase& draw);

}  // namespace rayproof
