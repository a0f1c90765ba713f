#pragma once
/// \file
/// What changes while the slider moves: t, the point, and what the stage reads out.

#include <string>
#include <vector>

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// One quantity at the slider's place.
struct LiveValue {
  std::string label;    ///< "p(t)"
  std::string rounded;  ///< operation by operation in the case's precision: the shortest decimal of it
  std::string exact;    ///< in real numbers; empty for a float64 case, whose readouts are doubles themselves
};

/// The numbers at `t`, a number of the case's precision. The point is `origin + t·direction`, rounded as
/// rayproof::point_at rounds it; a readout is its polynomial by Horner's rule.
[[nodiscard]] std::vector<LiveValue> live_values(const StageSlider& slider, double t, Precision precision);

/// The point as the precision has it.
[[nodiscard]] glm::dvec3 point_on(const StageSlider& slider, double t, Precision precision);

/// The number of the precision `count` places after t (before it, where negative).
[[nodiscard]] double neighbour_of(double t, int count, Precision precision);

}  // namespace rayproof::viz
