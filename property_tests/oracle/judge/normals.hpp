#pragma once
/// \file
/// How far a claimed normal is from those of the parts of a surface that a point may lie on.

#include <algorithm>

#include "oracle/geometry/sizes.hpp"
#include "oracle/judge/judging.hpp"

namespace rayproof::oracle {

/// The least relative change of a vector that turns it into the direction of another: the sine of the angle
/// between them, and 1 from a right angle on.
[[nodiscard]] inline Scaled turn(const Vector<Scaled>& from, const Vector<Scaled>& to) {
  if (dot(from, to).sign() <= 0) return Scaled(1);
  return norm(cross(from, to)) / (norm(from) * norm(to));
}

/// The normal of a part as the world has it, of unit length, and by what factor errors may turn it.
struct WorldNormal {
  Vector<Scaled> along;
  Scaled condition;

  WorldNormal(const ExactIntersection& exact, const SurfacePart& part, const Quotient& t)
      : along{}, condition(part.condition) {
    Vector<Ring> normal = part.normal.offset;
    if (part.normal.slope) normal = t.denominator() * normal + t.numerator() * *part.normal.slope;
    Scaled length = norm(normal);
    const auto& map = exact.ray().map;
    if (map) {
      const Scaled own_length = length;
      normal = map->apply_transposed(normal);
      length = norm(normal);
      condition =
          condition * own_length * MapSizes<Ring>(*exact.question().transform, *map).backward / length;
    }
    const Vector<Scaled> read_normal{approximate(normal.x), approximate(normal.y), approximate(normal.z)};
    along = {read_normal.x / length, read_normal.y / length, read_normal.z / length};
  }
};

/// By how much a claimed normal turns away from that of the part that it fits best, in units of the part's
/// condition, or by how much farther than the nearest part that one is, whichever is more; or how far it is
/// from unit length. The nearest part is the first.
[[nodiscard]] inline Scaled error_of_normal(const ExactIntersection& exact, const SurfaceParts& parts,
                                            const Quotient& t, const glm::dvec3& claimed) {
  const auto own = Vector<Scaled>::from(claimed);
  Scaled least = endless();
  for (const SurfacePart& part : parts) {
    const Scaled farther = part.apart - parts.front().apart;
    if (!(farther < least)) continue;
    const WorldNormal normal(exact, part, t);
    reduce(least, std::max(farther, turn(own, normal.along) / normal.condition));
  }
  const auto exactly = Vector<Ring>::from(claimed);
  const Scaled length = abs(approximate(dot(exactly, exactly) - Ring(1.0))) / Scaled(2);
  return std::max(least, length);
}

/// Of one that is no number: as if it were turned as far as can be.
[[nodiscard]] inline Scaled error_of_nan(const ExactIntersection& exact, const SurfaceParts& parts,
                                         const Quotient& t) {
  return Scaled(1) / WorldNormal(exact, parts.front(), t).condition;
}

/// Of no normal, where the surface has one: the same. Near an edge, where it has several, as much as p(t) is
/// farther from the second part than from the nearest.
[[nodiscard]] inline Scaled error_of_no_normal(const ExactIntersection& exact, const SurfaceParts& parts,
                                               const Quotient& t) {
  Scaled least = error_of_nan(exact, parts, t);
  for (std::size_t i = 1; i < parts.size(); ++i) reduce(least, parts[i].apart - parts.front().apart);
  return least;
}

}  // namespace rayproof::oracle
