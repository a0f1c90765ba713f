#pragma once
/// \file
/// Solids and rays of numbers so short that nothing made of them is rounded.

#include "generators/shapes/solid/scenes.hpp"
#include "generators/whole.hpp"

namespace rayproof::solid_family {

/// One of whole numbers; a box seldom has no thickness along an axis.
template <class Kind>
[[nodiscard]] Frame short_frame(Random& random) {
  Frame frame = Kind::whole(random);
  if constexpr (std::is_same_v<Kind, Boxes>)
    if (random.one_in(6)) frame.edges.at(static_cast<std::size_t>(random.between(0, 2))) *= 0;
  return frame;
}

/// Aimed at a face, an edge, a corner, or at a face's plane beside it, from within or without. The way from
/// one pair of faces to the other is short: no quotient of distances is rounded.
template <class Kind>
[[nodiscard]] Scene whole_numbers(Random& random) {
  const Frame frame = short_frame<Kind>(random);
  const int at_an_end = random.between(0, 3);
  const bool beside = random.one_in(3);
  const glm::dvec3 target =
      at(frame,
         place(random, at_an_end, [&] { return beside ? quarters(random, -1, 2) : quarters(random, 0, 1); }));
  const glm::dvec3 step = short_vector(random);
  const bool is_short_in_space = std::is_same_v<Kind, Boxes> && random.one_in(2);
  const glm::dvec3 sight = is_short_in_space ? step : along(frame, step);
  return looked_at_exactly(random, Kind::shape(frame), target, sight == glm::dvec3(0) ? step : sight);
}

}  // namespace rayproof::solid_family
