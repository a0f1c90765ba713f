#pragma once
/// \file
/// Counts as people write large ones.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <string>

namespace rayproof {

/// Takes 20000, 1e9 or 2.5e6 for a count from 1 to 1e12: an option's transformation. CLI11's own refuses an
/// exponent.
[[nodiscard]] inline CLI::Validator whole_count() {
  const auto read = [](std::string& text) -> std::string {
    char* end = nullptr;
    const double count = std::strtod(text.c_str(), &end);
    if (end == text.c_str() || *end != 0 || !(count >= 1 && count <= 1e12) || count != std::floor(count))
      return fmt::format("{} is not a whole number from 1 to 1e12", text);
    text = fmt::format("{:.0f}", count);
    return "";
  };
  return CLI::Validator(read, "COUNT");
}

}  // namespace rayproof
