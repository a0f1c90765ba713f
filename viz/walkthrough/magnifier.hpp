#pragma once
/// \file
/// A stretch of a line looked at from so near that single numbers can be distinguished.

#include "viz/scene/items.hpp"

namespace rayproof::viz {

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
