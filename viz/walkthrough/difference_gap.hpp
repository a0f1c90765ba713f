#pragma once
/// \file
/// A solid that a ray just misses, or just meets: rounding decides, and only from very near it is to be seen.

#include <array>
#include <optional>
#include <string>

#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {

/// Where the exact interval of t inside a solid begins and ends, and where the computed one does; an interval
/// that ends before it begins is empty.
struct Gap {
  double entry, exit;
  double computed_entry, computed_exit;
};

/// As the kernels call the ends, and an exit that is moved on.
inline constexpr std::array<const char*, 3> gap_names{"t_entry", "t_exit", "t_padded"};

/// The gap of a run that names both ends, where it is narrow.
[[nodiscard]] std::optional<Gap> gap_of(const CaseReport& report);

/// Both intervals beside the ray, magnified.
void show_gap(StageStep& step, const Gap& gap, Precision precision, const Setting& setting);

/// The step that moves the exit on, where the planes of entry and exit meet in an edge that the ray nearly
/// touches: that edge seen end-on, with the box as it is and as it counts.
[[nodiscard]] std::optional<StepSpace> padded_space(const CaseReport& report, const StageCamera& camera);

/// "Exactly the ray is in at 1, out at 0.999999886; …"
[[nodiscard]] std::string in_words(const Gap& gap, Precision precision);

}  // namespace rayproof::viz
