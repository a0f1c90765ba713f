#pragma once
/// \file
/// What a subject's answers hold, and which questions its documentation says it takes.

#include "subjects/boundary_places.hpp"

namespace rayproof {

/// What a subject's answers hold. What they leave out is not judged.
struct Abilities {
  bool all_hits = true;  ///< every hit in the interval; otherwise the nearest alone
  bool numbers = true;   ///< the t of hits, the roots; otherwise the verdict, or the kind of roots, alone
  bool contact = true;
  bool point = true;
  bool normal = true;
  bool barycentric = true;
  bool boundary = true;  ///< says of a point that it is on the boundary of a polygon
  /// Where its wrong verdict is a rule of its own, and not what rounding makes of it.
  BoundaryPlaces rules{~0ULL};
  unsigned wrong_on_boundaries = 0;  ///< verdicts, of this many cases:
  unsigned asked_on_boundaries = 0;
};

/// The questions that a subject's documentation says it takes. What breaks outside is a fault of nobody;
/// where nothing is documented, every valid case is inside.
struct DocumentedDomain {
  enum class Ends { closed, half_open };
  bool unit_direction = false;  ///< directions of length 1 alone
  bool interval = true;      ///< it knows t_min and t_max; otherwise rays from their origin on, without end
  Ends ends = Ends::closed;  ///< whether edges, vertices and the ends of the interval are promised
  int smallest = -1074;      ///< log2 of the smallest length
  int largest = 1024;        ///< log2 of the largest
};

}  // namespace rayproof
