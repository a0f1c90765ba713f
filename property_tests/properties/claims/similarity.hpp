#pragma once
/// \file
/// Cases that must have the same answer but for a factor: scaled by powers of two, mirrored, moved.

#include <optional>

#include "case/case.hpp"

namespace rayproof {

/// Another case, whose answers must be `factor` times those of the first.
struct Twin {
  Case one{};
  double factor = 1;
};

/// The case with its lengths (the roots of a quadratic) and its direction (the equation as a whole)
/// multiplied by these factors. t grows with the first and shrinks with the second.
[[nodiscard]] Twin scaled_twin(const Case& one, double lengths, double whole);

/// The ray run backwards, or the equation of -x.
[[nodiscard]] Twin reversed_twin(const Case& one);

/// Object and ray moved together by one of a few affine maps, chosen by the case's own bits; the moved ray is
/// rounded to the case's precision. Nothing for a question without a place, or one that bears a transform
/// already.
[[nodiscard]] std::optional<Case> moved_case(const Case& one);

}  // namespace rayproof
