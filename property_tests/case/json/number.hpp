#pragma once
/// \file
/// Numbers as JSON for what is no case: reports, explanations, stages.

#include <cmath>
#include <nlohmann/json.hpp>

namespace rayproof {

/// JSON has no infinity and no NaN: the case format's strings stand for them.
[[nodiscard]] inline nlohmann::ordered_json json_number(double x) {
  if (std::isfinite(x)) return x;
  return std::isnan(x) ? "nan" : x > 0 ? "inf" : "-inf";
}

}  // namespace rayproof
