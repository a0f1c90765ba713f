#pragma once
/// \file
/// What tests of stages have in common: how the report on a lesson is made, and how its data is read.

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "viz/programs/report_of.hpp"

namespace rayproof::viz {

[[nodiscard]] inline CaseReport report_lesson(const Case& one, const std::string& method) {
  return report_of(one, method);
}

/// A number of the data: JSON has no infinities.
[[nodiscard]] inline double number_in(const nlohmann::json& json) {
  if (json.is_number()) return json.get<double>();
  return json == "inf" ? INFINITY : json == "-inf" ? -INFINITY : NAN;
}

}  // namespace rayproof::viz
