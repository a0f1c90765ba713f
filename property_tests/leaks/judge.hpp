#pragma once
/// \file
/// One ray at a patch of triangles: what is true of it, and what a method says.

#include <optional>
#include <span>

#include "leaks/search.hpp"

namespace rayproof::leaks {

/// A ray with what is true of it: it crosses the patch once.
struct PatchCrossing {
  std::uint64_t number = 0;
  Aim aim{};
  std::vector<Case> cases{};
  std::vector<bool> is_hit{};
};

/// The ray that a seed stands for. Nothing where the ray passes the patch by, or the patch is folded so that
/// it is met twice.
[[nodiscard]] std::optional<PatchCrossing> crossing_of(const Targets& targets, std::uint64_t number,
                                                       std::uint64_t seed, Precision precision);

/// Counts what a method says of each triangle of the patch.
void judge(Outcomes& into, const PatchCrossing& crossing, std::span<const Outcome> outcomes);

}  // namespace rayproof::leaks
