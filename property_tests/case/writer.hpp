#pragma once
/// \file
/// Writes cases and answers as lines of JSON, as the case format says. No line ends in a newline.

#include <cstddef>
#include <string>

#include "case/answer.hpp"
#include "case/case.hpp"
#include "case/reader.hpp"

namespace rayproof {

/// The case, such that `read_case` gives it back bit for bit. Numbers have as few digits as that allows. A
/// case that the format refuses (a NaN put there on purpose) is written all the same.
[[nodiscard]] std::string write_case(const Case& one);

/// The same case with all digits that a double takes: who reads its numbers as doubles, and does not round
/// them to its precision, has the same numbers.
[[nodiscard]] std::string write_case_for_doubles(const Case& one);

/// The answer to `one`, whoever gave it.
[[nodiscard]] std::string write_answer(const Case& one, const Answer& answer);

/// What takes an answer's place for a refused line; lines count from 1.
[[nodiscard]] std::string write_refusal(const RefusedCase& refused, std::size_t line);

}  // namespace rayproof
