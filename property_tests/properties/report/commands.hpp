#pragma once
#include <fmt/format.h>

#include <string>

#include "case/writer.hpp"
#include "properties/report/summary.hpp"

namespace rayproof {

/// The finding's case between single quotes, as a shell wants it; the quotes that it may hold itself are
/// escaped.
[[nodiscard]] inline std::string quoted_case(const Finding& finding) {
  std::string quoted = "'";
  for (const char letter : write_case(finding.one)) {
    quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return quoted + "'";
}

/// The one command that shows step by step how the method came to its answer.
[[nodiscard]] inline std::string walk_command(const Finding& finding) {
  return fmt::format("./rayproof walk --case {} --method {} --html finding.html", quoted_case(finding),
                     finding.subject->full_name());
}

}  // namespace rayproof
