#pragma once
/// \file
/// The CASE of a command line: a file, standard input, the case itself, or a finding of `rayproof check`, by
/// its number or as its line.

#include <optional>
#include <string>
#include <string_view>

#include "case/case.hpp"
#include "case/findings_file.hpp"
#include "subjects/command.hpp"

namespace rayproof::viz {

struct CaseArgument {
  Case one;
  std::string method{};     ///< "sphere/textbook" where the case came in a finding; else empty
  std::string command{};    ///< the shell line where the finding's subject is a program
  bool is_answered = true;  ///< false of a finding that the program gave no answer
  /// How long that may be silent.
  std::chrono::milliseconds case_time{usual_case_time};
};

/// The text a CASE stands for: the argument itself where it begins with a brace; where it is a number, the
/// finding of that number in the file or folder `findings`; else the file's line `line`, from 1 as an editor
/// counts; without one, its one JSON text, or its first line that is not blank. Throws UnreadableCase.
[[nodiscard]] std::string text_of_case(const std::string& argument, std::optional<std::size_t> line = {},
                                       const std::string& findings = last_findings);

/// The case, or the finding's, in its own precision or in the one given. Throws a Refusal.
[[nodiscard]] CaseArgument read_case_argument(std::string_view text, std::optional<Precision> precision = {});

}  // namespace rayproof::viz
