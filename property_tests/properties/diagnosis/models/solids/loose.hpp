#pragma once
/// \file
/// Models of solids that are taken for larger or smaller than they are by a small fixed length.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A box, or a cylinder's height, that is larger by this at each end, or smaller where it is negative; a
/// parallelepiped by this share of its edges.
[[nodiscard]] std::vector<Case> widened(const Case& one, double by);
[[nodiscard]] Answers narrowed(const Case& one, const Answer& exact, double by);
template <int power>
[[nodiscard]] std::vector<Case> widened_by(const Case& one) {
  return widened(one, std::pow(10.0, power));
}
/// A solid of which nothing is left is missed.
template <int power>
[[nodiscard]] Answers narrowed_by(const Case& one, const Answer& exact) {
  return narrowed(one, exact, std::pow(10.0, power));
}

/// A box that is thinner than that along an axis is made as thick there: beyond its max, or about its middle.
/// An answer for each.
[[nodiscard]] Answers thickened(const Case& one, double least);
template <int power>
[[nodiscard]] Answers thickened_to(const Case& one, const Answer& /*exact*/) {
  return thickened(one, std::pow(10.0, power));
}

}  // namespace rayproof::diagnosis
