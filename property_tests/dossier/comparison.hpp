#pragma once
/// \file
/// What a library said beside what is right by hand.

#include <string>

#include "dossier/by_hand.hpp"
#include "dossier/library.hpp"

namespace rayproof::dossier {

/// How the two differ.
struct Comparison {
  bool is_wrong = false;
  std::string expected{};  ///< "a hit at t = 1/2", "no hit", "inside"
  std::string deed{};      ///< what the library does, as a title has it: "misses a box that …"
};

/// `shape` is a topic; numbers of a float case may differ by rounding in float.
[[nodiscard]] Comparison compare(const HandCalculation& right, const Reproduction& library,
                                 const std::string& shape, Precision precision);

}  // namespace rayproof::dossier
