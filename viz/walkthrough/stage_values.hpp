#pragma once
/// \file
/// The numbers of a walkthrough as a stage shows them, in words and formulas, at the slider's place, and what
/// a step says, taken apart.

#include <optional>
#include <string>
#include <vector>

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// Values named name.x, name.y, name.z together, in the order of naming.
[[nodiscard]] std::vector<StageValue> grouped(const std::vector<WalkValue>& values);

/// The value's formula, where it says more than the name: "1/d" is 1 / d, and "min - o" min − o.
[[nodiscard]] std::string formula_beside_name(const StageValue& value);

/// The rounded number as the shortest decimal that reads back as it; a vector's in parentheses.
[[nodiscard]] std::string shown(const StageValue& value, Precision precision);

/// The exact number as exact_beside writes it; a vector's in parentheses.
[[nodiscard]] std::string exact_of(const StageValue& value);
[[nodiscard]] const WalkValue& worst_component(const StageValue& value);

/// What the values' own formulas lost, whatever else their step lost in other parts.
[[nodiscard]] std::optional<PrecisionLoss> worst_loss_of(const std::vector<StageValue>& values);

/// "D = b·b − 4·a·c = 3·3 − 4·1·2 = 1"
[[nodiscard]] std::string equation_of(const StageValue& value, Precision precision);

/// "p is a point. t is its place." as two.
[[nodiscard]] std::vector<std::string> sentences_of(const std::string& text);

/// Whether a sentence speaks of a number of that name. "a" is an article, too, and never counts.
[[nodiscard]] bool mentions(const std::string& sentence, const std::string& name);

/// How many letters a text has; combining marks are none.
[[nodiscard]] std::size_t letters_of(const std::string& text);

struct LiveValue {
  std::string label;    ///< "p(t)"
  std::string rounded;  ///< operation by operation in the case's precision: the shortest decimal of it
  std::string exact;    ///< in real numbers; empty for a float64 case, whose readouts are doubles themselves
};

/// The numbers at `t`, a number of the case's precision. The point is `origin + t·direction`, rounded as
/// rayproof::point_at rounds it; a readout is its polynomial by Horner's rule.
[[nodiscard]] std::vector<LiveValue> live_values(const StageSlider& slider, double t, Precision precision);
/// The number of the precision `count` places after t (before it, where negative).
[[nodiscard]] double neighbour_of(double t, int count, Precision precision);

}  // namespace rayproof::viz
