#pragma once
/// \file
/// Which method to take, by the figures: the report's last table, and its first plot.

#include <optional>
#include <string>
#include <vector>

#include "bench/figures/summary.hpp"

namespace rayproof::report {

/// What the rays of a scene are like; the families of cases stand for it.
enum class Scenes {
  near_by,      ///< family `random`: about as far away as they are large
  from_afar,    ///< family `far`: 10² to 10⁶ sizes away
  transformed,  ///< families `transformed` and `placed`: under a matrix
  hard          ///< all others of scenes: edges, tangents, origins on the surface …
};

[[nodiscard]] const char* name_of(Scenes scenes);

/// For one shape, one precision and one kind of scene: the methods to choose from. Batches are compared where
/// the shape has them, else one ray at a time; methods that are not sound are left out.
struct Choice {
  Scenes scenes = Scenes::near_by;
  MethodSummary fastest{};
  MethodSummary closest{};  ///< of those at most twice as expensive: the fewest wrong verdicts, then the
                            ///< fewest bits of error
  std::optional<MethodSummary> exact{};  ///< the fastest with every verdict right and every t rounded rightly
  std::optional<double> oracle_ns{};     ///< what an exact verdict of the oracle costs there
};

/// In the order of the rows' shapes and precisions.
[[nodiscard]] std::vector<Choice> choose(const std::vector<BenchRow>& rows);

/// What the contract of a method promises, in a few words: "verdict exact, t rounded once: proven".
[[nodiscard]] std::string guarantee_of(const MethodSummary& method);

}  // namespace rayproof::report
