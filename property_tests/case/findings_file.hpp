#pragma once
/// \file
/// The findings of a run of `rayproof check` by their numbers: finding N is line N of the run's file.

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace rayproof {

/// Where `rayproof check` keeps the findings of its last run, unless --out names another folder.
inline constexpr const char* last_findings = "out/check/findings.jsonl";

/// A file that can't be read, or has no such line; the text says so in one sentence.
class UnreadableCase : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The number where the text is one, from 1 and of digits alone: "12" is finding 12, "./12" a file.
[[nodiscard]] std::optional<std::size_t> finding_number(const std::string& text);

/// The lines of the text as an editor numbers them, blank ones, too.
[[nodiscard]] std::vector<std::string> lines_in(const std::string& text);
/// Whether there is nothing in the line but white space.
[[nodiscard]] bool is_blank(const std::string& line);

/// The file of findings that --from names: itself, or the one in the folder of a run.
[[nodiscard]] std::string findings_named(const std::string& from);

/// The finding of that number in the file of a run, or in the run's folder. Throws UnreadableCase.
[[nodiscard]] std::string finding_line(const std::string& from, std::size_t number);

}  // namespace rayproof
