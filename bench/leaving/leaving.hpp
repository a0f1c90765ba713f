#pragma once
/// \file
/// Leaving the surface, over the size of the scene: how far each strategy's offset goes, and how often its
/// ray meets again what it has left.

#include <string>

#include "properties/leaving/search.hpp"

namespace rayproof::report {

/// One SVG of four charts: offsets above false hits, float32 beside float64.
[[nodiscard]] std::string leaving_svg(const leaving::SearchResult& result);

}  // namespace rayproof::report
