#pragma once
/// \file
/// What is right for the very numbers that a library was given, by the formula that one would use with paper
/// and pencil, in exact fractions. It shares nothing with the oracle, whose answer it confirms.

#include <string>
#include <vector>

#include "dossier/library.hpp"

namespace rayproof::dossier {

/// The outcome of a calculation by hand.
struct HandCalculation {
  std::vector<std::string> steps{};  ///< each a sentence with its numbers
  /// The hits that count, ascending: the t of origin + t·direction, or the fraction of the way from start to
  /// end.
  std::vector<double> hits{};
  std::vector<std::string> hits_as_text{};  ///< the same, as fractions where they are not decimals
  std::vector<double> barycentric{};        ///< of a triangle's hit, of b and c
  bool is_position = false;                 ///< the question is where a point is, not where a ray hits
  bool is_inside = false, is_on_boundary = false;

  [[nodiscard]] bool is_hit() const { return is_position ? is_inside : !hits.empty(); }
};

/// By the topic ("sphere", …) and the numbers that were given. Throws std::runtime_error where some are
/// missing.
[[nodiscard]] HandCalculation by_hand(const std::string& topic, const NamedNumbers& inputs);

}  // namespace rayproof::dossier
