#pragma once
/// \file
/// A hit from which a ray is to leave: drawn from the families of cases, at any scale, to either side, in
/// every kind of direction.

#include <optional>
#include <rayproof/spawn.hpp>
#include <string>
#include <vector>

#include "generators/generators.hpp"
#include "oracle/leaving/leaving.hpp"
#include "subjects/subject.hpp"

namespace rayproof::leaving {

/// What makes a situation, besides what follows from it: the ray that hits, which hit, and where to from
/// there.
struct Departing {
  Case incoming{};  ///< a ray and a shape
  std::size_t hit = 0;
  spawn::Side side{};
  glm::dvec3 direction{};
};

/// A hit of a plain method, and a direction. All numbers are of the incoming case's precision.
struct Situation {
  Departing what{};
  spawn::SurfacePoint<double> from{};  ///< for the side; float numbers stand in doubles exactly
  oracle::SurfacePiece piece{};
  oracle::SceneExtent extent{};
  bool is_turned_back = false;  ///< `from` looks to the back
  bool has_normal = true;       ///< the library found a point and a normal to leave it by

  [[nodiscard]] Precision precision() const { return what.incoming.precision; }
  [[nodiscard]] const RayQuestion& question() const { return std::get<RayQuestion>(what.incoming.question); }
  /// The ray that leaves, from this origin.
  [[nodiscard]] RayQuestion leaves_from(const glm::dvec3& origin) const;
  /// The same situation left to another side, or in another direction. A body too thin to be left to its
  /// inside is left to its outside.
  [[nodiscard]] Situation turned(spawn::Side side, const glm::dvec3& direction) const;
};

/// Scenes of other sizes (a family may have its own before it is enlarged) are left out.
inline constexpr double smallest_scene = 1e-8, largest_scene = 1e8;

/// A round body thinner than this many units roundoff of its scene is a handful of numbers wide: it is left
/// out.
inline constexpr double thinnest_round = 64;

/// Which of two opposite faces of a parallelepiped is the lower one is known by a height, whose sign may be
/// wrong where it is smaller than its own rounding error: one thinner than this many units roundoff is left
/// out.
inline constexpr double thinnest_slanted = 32;

/// A solid thinner than this many units roundoff of its scene has no inside that its numbers could name: rays
/// go back out of it.
inline constexpr double thinnest_inside = 1024;

/// The situation, or nothing where the method has no such hit, or a flat shape no area and so no normal. A
/// solid always has one: where the library finds none, every strategy fails.
[[nodiscard]] std::optional<Situation> situation_of(Departing what);

/// The families of a topic whose scenes have lengths that a program would have.
[[nodiscard]] std::vector<const Family*> families_of(const std::string& topic);

/// The plain method whose hits are left, of a topic with rays; else null.
[[nodiscard]] const Subject* plain_method_of(const std::string& topic);

/// The shapes' topics, in the order of the registries.
[[nodiscard]] std::vector<std::string> topics_with_rays();

/// A hit costs more than a ray that leaves it: each is left so often, to either side.
inline constexpr std::uint64_t rays_from_a_hit = 4;

/// The situations that a seed stands for: none where no attempt came to a hit.
[[nodiscard]] std::vector<Situation> draw_situations(const std::vector<const Family*>& from,
                                                     std::uint64_t seed, Precision precision);

}  // namespace rayproof::leaving
