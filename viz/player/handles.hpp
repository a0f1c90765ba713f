#pragma once
/// \file
/// What of a case can be taken hold of in its scene, and the case that comes of moving it.

#include <functional>
#include <string>
#include <vector>

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// Rounds coordinates that moved.
class Rounding {
 public:
  /// `resolution` is how far apart two places are that can just be distinguished.
  Rounding(double resolution, Precision precision) : resolution_(resolution), precision_(precision) {}

  /// The shortest decimal that distinguishes `next` at this resolution, then a number of the precision; `old`
  /// where it did not move.
  [[nodiscard]] double operator()(double old, double next) const;
  [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& old, const glm::dvec3& next) const;
  /// The same for lengths of which each appears as `factor` of them.
  [[nodiscard]] Rounding magnified(double factor) const { return {resolution_ / factor, precision_}; }

 private:
  double resolution_;
  Precision precision_;
};

/// A point to take hold of: of the ray its origin or the tip of its arrow, of a shape what defines it, of a
/// transform its translation or the tip of one of its axes.
struct Handle {
  std::string name;  ///< "origin", "tip", "center", "vertices 2"; each once in a case
  glm::dvec3 at{};
  /// Writes the place to which it was moved into a case: of the case from which the handle was made.
  std::function<void(Case& next, const glm::dvec3& to, const Rounding& round)> move{};
};

/// The handles in the view of a step, those of the ray first. None where the step shows something else than
/// the case: a scene of its own, or another ray.
[[nodiscard]] std::vector<Handle> handles_of(const Stage& stage, std::size_t step);

/// The handles of the shape and of its transform, wherever they are; `size` is about the view's radius,
/// `aside` the direction in which a radius lies.
[[nodiscard]] std::vector<Handle> shape_handles(const Case& one, double size, const glm::dvec3& aside);

/// The case with the handle moved to `to`. Coordinates that the move changes become the shortest decimals
/// that distinguish points at a distance of `resolution`, then numbers of the case's precision; the others
/// keep their bits. Throws a Refusal where the format refuses the case: a zero direction, say.
[[nodiscard]] Case moved(const Case& one, const Handle& handle, const glm::dvec3& to, double resolution);

}  // namespace rayproof::viz
