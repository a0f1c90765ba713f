#pragma once
/// \file
/// A finding as the findings file of a run has it.

#include <string>
#include <string_view>

#include "properties/finding.hpp"

namespace rayproof::dossier {

/// A finding read back. `finding` has no subject: whoever was on trial is known by name alone.
struct RecordedFinding {
  std::string shape{};  ///< "sphere"
  std::string name{};   ///< who was on trial: "glm-line"
  std::string kind{};   ///< "gross"
  std::string says{};   ///< what it does with the case, and what is exact, in words
  Finding finding{};
};

/// Reads a line of a findings file. Throws std::runtime_error with one sentence where it is none.
[[nodiscard]] RecordedFinding read_recorded(std::string_view line, std::size_t number);

}  // namespace rayproof::dossier
