#pragma once
/// \file
/// Cases that must have the same answer but for a factor: scaled by powers of two, mirrored, moved.

#include <array>
#include <optional>

#include "case/case.hpp"

namespace rayproof {

/// Another case, whose answers must be `factor` times those of the first.
struct Twin {
  Case one{};
  double factor = 1;
};

/// Powers of two for the lengths of a scene and for the length of the direction (or, for a quadratic, for its
/// roots and for the equation as a whole). t grows with the first and shrinks with the second.
struct Scaling {
  int lengths = 0;
  int whole = 0;
};
inline constexpr std::array<Scaling, 3> scalings{{{1, 0}, {0, 1}, {-3, 4}}};
/// The largest shift of an exponent in `scalings`.
inline constexpr int scaling_reach = 4;

[[nodiscard]] Twin scaled_twin(const Case& one, const Scaling& by);

/// The ray run backwards, or the equation of -x.
[[nodiscard]] Twin reversed_twin(const Case& one);

/// Object and ray moved together by one of a few affine maps, chosen by the case's own bits; the moved ray is
/// rounded to the case's precision. Nothing for a question without a place, or one that bears a transform
/// already.
[[nodiscard]] std::optional<Case> moved_case(const Case& one);

}  // namespace rayproof
