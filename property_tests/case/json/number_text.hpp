#pragma once
/// \file
/// Numbers as the case format writes them, to and from doubles, the same in every locale.

#include <string>
#include <string_view>

#include "case/case.hpp"
#include "case/json/parse_number.hpp"

namespace rayproof {

/// Of an infinity or NaN spelt as some language spells it ("Infinity", "+inf", "-INF", "NaN"), the case
/// format's spelling; empty for any other text.
[[nodiscard]] std::string_view case_spelling(std::string_view text);

/// `x` rounded to the nearest number of a precision, ties to even.
[[nodiscard]] double round_to(Precision precision, double x);

/// The shortest JSON that reads back, rounded to the precision, as exactly `x`: a number, or "inf", "-inf",
/// "nan" in quotes. The float nearest to 0.1 is 0.1 as a float32 and 0.10000000149011612 as a float64. Minus
/// zero keeps its sign as -0.0, since -0 is an integer to many readers.
void append_number(std::string& out, double x, Precision precision = Precision::float64);

/// `x` as JSON in quotes in the form of printf's %a: "0x1.8p+1", "-0x0p+0", "inf".
void append_hex(std::string& out, double x);

}  // namespace rayproof
