#pragma once
/// \file
/// JSON of what is no case: reports, explanations, stages. Read and written out of line, since in each source
/// that does so itself g++ works longer on nlohmann's parser than on all else.

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace rayproof {

/// JSON has no infinity and no NaN: the case format's strings stand for them.
[[nodiscard]] inline nlohmann::ordered_json json_number(double x) {
  if (std::isfinite(x)) return x;
  return std::isnan(x) ? "nan" : x > 0 ? "inf" : "-inf";
}

/// An array of what `as_json` makes of each element.
[[nodiscard]] nlohmann::ordered_json json_list(const auto& elements, auto&& as_json) {
  auto list = nlohmann::ordered_json::array();
  for (const auto& element : elements) list.push_back(as_json(element));
  return list;
}

/// Where the text is not JSON: throws nlohmann's parse_error, or gives a discarded value.
[[nodiscard]] nlohmann::ordered_json read_json(std::string_view text, bool throws = true);

/// On one line, or on lines indented by this many blanks.
[[nodiscard]] std::string write_json(const nlohmann::ordered_json& json, int indent = -1);

}  // namespace rayproof
