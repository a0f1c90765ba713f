#pragma once
/// \file
/// The CASE of a command line: a file, standard input, the case itself, or a finding of `rayproof check`.

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "case/case.hpp"

namespace rayproof::viz {

struct CaseArgument {
  Case one;
  std::string method{};  ///< "sphere/textbook" where the case came in a finding; else empty
};

/// The file can't be read, or has no such line; the text says so in one sentence.
class UnreadableCase : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The text a CASE stands for: the argument itself where it begins with a brace, the file's one JSON text, or
/// its line number `line` (from 1, blank lines not counted). Throws UnreadableCase.
[[nodiscard]] std::string text_of_case(const std::string& argument, std::size_t line);

/// The case, or the finding's, in its own precision or in the one given. Throws a Refusal.
[[nodiscard]] CaseArgument read_case_argument(std::string_view text, std::optional<Precision> precision = {});

}  // namespace rayproof::viz
