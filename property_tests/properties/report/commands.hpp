#pragma once
/// \file
/// The commands that look into a finding.

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "case/findings_file.hpp"
#include "properties/finding.hpp"

namespace rayproof {

/// " --from DIR/findings.jsonl" for a run whose folder is not the usual one, so that its findings' numbers
/// are found; else empty.
[[nodiscard]] inline std::string from_option(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "findings.jsonl";
  if (file.lexically_normal() == last_findings) return "";
  std::string quoted;
  for (const char letter : file.string()) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
  const bool is_plain = quoted.find_first_not_of(
                            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                            "/._-") == std::string::npos;
  return " --from " + (is_plain ? quoted : "'" + quoted + "'");
}

/// One command a line.
[[nodiscard]] inline std::string commands_for(const Finding& finding, const std::filesystem::path& folder) {
  std::string lines;
  for (const char* const command : {"explain", "walk", "draw", "replay"})
    lines += fmt::format("./rayproof {} {}{}\n", command, finding.number, from_option(folder));
  return lines;
}

}  // namespace rayproof
