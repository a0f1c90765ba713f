#pragma once
/// \file
/// What only from very near is to be seen: a stretch of a line on which single numbers can be distinguished,
/// and a solid that a ray just misses, or just meets.

#include <array>
#include <optional>
#include <string>

#include "viz/scene/items.hpp"
#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {

/// Where the exact interval of t inside a solid begins and ends, and where the computed one does; an interval
/// that ends before it begins is empty.
struct Gap {
  double entry, exit;
  double computed_entry, computed_exit;
  const char* computed_exit_name;  ///< an exit that is moved on has a name of its own
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

/// "Exactly, t_entry = 1 and t_exit = 0.999999886; …"
[[nodiscard]] std::string in_words(const Gap& gap, Precision precision);

/// Where a number lies on the magnified line: the centre's is 0, and `unit` more is one length along.
struct Magnifier {
  double centre = 0;
  double unit = 1;
  glm::dvec3 along{1, 0, 0};
  [[nodiscard]] glm::dvec3 at(double t) const { return (t - centre) / unit * along; }
};

/// A dot for each number of the precision around one of them: between them there is nothing for an answer.
[[nodiscard]] Items dots_of(const Magnifier& magnifier, double around, Precision precision);

/// "Each dot is a float32 value."
[[nodiscard]] std::string dots_in_words(Precision precision);

/// What magnified steps show: numbers up to this many lengths from the centre.
inline constexpr double magnified_reach = 3.2;

}  // namespace rayproof::viz
