#pragma once
/// \file
/// Guests: subjects without a contract of their own, whose answers may leave out a part.

#include "oracle/oracle.hpp"
#include "subjects/subject.hpp"

namespace rayproof {

/// The answer with what is left out filled in by what is exact, so that only what is said is judged: a
/// position on the boundary for one who never says so, the roots where only their kind is given, and the
/// nearest hit alone, the verdict alone, two equal hits for one, as what they are.
[[nodiscard]] Answer completed(const Subject& subject, const Case& one, const Answer& given);

/// The judgement on a guest's completed answer. A guest that gives the nearest hit alone, and gives another
/// of the line's, misses the nearer one.
[[nodiscard]] oracle::Judgement judged(const Case& one, const Answer& claimed);

/// Whether the case may be given to a guest: every number of it that is not 0 lies in the domain of its
/// contract, and a solid's edges do not lie in one plane but for rounding. Beyond that nothing is judged, and
/// honest arithmetic overflows, or divides by a determinant that rounds to 0.
[[nodiscard]] bool is_for_guest(const Subject& guest, const Case& one);

/// Whether two cases ask the same of the same numbers, bit for bit; their ids and notes don't count.
[[nodiscard]] bool is_same_question(const Case& a, const Case& b);

}  // namespace rayproof
