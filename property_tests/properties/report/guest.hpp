#pragma once
/// \file
/// What a run says of guests: what was judged, what not and why, and what was found.

#include <string>

#include "properties/report/summary.hpp"

namespace rayproof {

/// For each guest a line on how many cases it answered and with which findings, and under it what was not
/// judged, and why.
[[nodiscard]] std::string text_guests(const Plan& plan, const RunResult& result);

/// The same for other programs, a line of JSON for each guest and shape that it knows: `shape`, `method`,
/// `seed`, `cases_each` (for each family and precision), `cases`, `unsupported`, `failures`, `judged` (how
/// many cases by the claim's name), `not_judged` (in words).
[[nodiscard]] std::string json_guests(const Plan& plan, const RunResult& result);

/// One sentence: a clean bill, or how many findings; whether some claim of a guest was judged at all.
struct GuestVerdict {
  std::string sentence{};
  bool is_clean = false;
};
[[nodiscard]] GuestVerdict verdict_on_guests(const Plan& plan, const RunResult& result);

}  // namespace rayproof
