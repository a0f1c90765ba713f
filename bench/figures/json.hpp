#pragma once
#include <stdexcept>
#include <string>

#include "bench/figures/row.hpp"

namespace rayproof::report {

/// Text that is no report's JSON; the message names the place.
class FiguresError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One object: `machine`, `compiler` and `rows` (docs/report.md). What is NaN is null there.
[[nodiscard]] std::string to_json(const Measurements& figures);

/// The same read again. Throws FiguresError.
[[nodiscard]] Measurements from_json(const std::string& text);

}  // namespace rayproof::report
