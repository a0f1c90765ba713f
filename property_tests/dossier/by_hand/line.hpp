#pragma once
/// \file
/// The line that a library was given, and which part of it counts.

#include <optional>

#include "dossier/by_hand.hpp"
#include "dossier/by_hand/fractions.hpp"

namespace rayproof::dossier {

/// origin + t·direction, or start + t·(end - start).
struct HandLine {
  FractionVector origin{}, direction{};
  bool is_segment = false;
  std::optional<Fraction> t_min{}, t_max{};  ///< nothing where there is no end

  [[nodiscard]] FractionVector at(const Fraction& t) const { return origin + t * direction; }
  [[nodiscard]] bool counts(const Fraction& t) const {
    return (!t_min || *t_min <= t) && (!t_max || t <= *t_max);
  }
  /// "0 ≤ t", "0 ≤ t ≤ 1", "all t".
  [[nodiscard]] std::string range() const;
};

[[nodiscard]] HandLine line_in(const NamedNumbers& inputs);

/// Puts the t that count into the calculation, with a sentence that names all of them.
void keep_hits(HandCalculation& calculation, const HandLine& line, const std::vector<HandNumber>& all);

// The shapes, each by its formula.
void sphere_by_hand(HandCalculation& calculation, const HandLine& line, const NamedNumbers& inputs);
void plane_by_hand(HandCalculation& calculation, const HandLine& line, const NamedNumbers& inputs);
void triangle_by_hand(HandCalculation& calculation, const HandLine& line, const NamedNumbers& inputs);
void polygon_by_hand(HandCalculation& calculation, const HandLine& line, const NamedNumbers& inputs);
void box_by_hand(HandCalculation& calculation, const HandLine& line, const NamedNumbers& inputs);
void cylinder_by_hand(HandCalculation& calculation, const HandLine& line, const NamedNumbers& inputs);
void position_by_hand(HandCalculation& calculation, const NamedNumbers& inputs);

/// A point of a plane and the corners of a polygon, each by two coordinates.
using FlatPoint = std::array<Fraction, 2>;

/// Where the point is: with a sentence on the sides that a level ray to the right crosses.
struct FlatPosition {
  bool is_inside = false, is_on_boundary = false;
  std::string sentence{};
};
[[nodiscard]] FlatPosition position_of(const FlatPoint& point, const std::vector<FlatPoint>& corners);

}  // namespace rayproof::dossier
