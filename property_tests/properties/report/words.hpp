#pragma once
/// \file
/// A finding in words.

#include <string>

#include "properties/finding.hpp"

namespace rayproof {

/// What the method does with the finding's case, and what is exact: "misses a sphere of radius 1 from 4500
/// away (exact 499.88943)".
[[nodiscard]] std::string in_words(const Finding& finding);

}  // namespace rayproof
