#pragma once
/// \file
/// The shrinker's moves: ways to a simpler case, the boldest first.

#include <array>
#include <functional>

#include "case/case.hpp"

namespace rayproof::shrink_moves {

/// Looks at a candidate, and takes it or not.
using Try = std::function<void(const Case&)>;

/// A move offers candidates made from `best`, which changes with each that is taken.
using Move = void (*)(const Case& best, const Try& attempt);

/// Leaves out the transform and the interval.
void drop_parts(const Case& best, const Try& attempt);
/// Leaves out vertices of a polygon: half of them, then one by one.
void drop_vertices(const Case& best, const Try& attempt);
/// Moves a point of the shape to the origin, the ray with it.
void move_to_origin(const Case& best, const Try& attempt);
/// Multiplies several numbers at once by one power of two or ten.
void rescale(const Case& best, const Try& attempt);
/// Makes one number simpler.
void simplify_one(const Case& best, const Try& attempt);
/// Puts the origin straight behind the shape, so far away as to make the case simple: a sphere that is far
/// enough is missed in plain numbers, too.
void look_straight(const Case& best, const Try& attempt);
/// Makes two numbers simpler at once, or equal.
void simplify_two(const Case& best, const Try& attempt);
/// Rounds all numbers at once to few digits, each with a little luck: for cases in which every digit seems to
/// count.
void round_all(const Case& best, const Try& attempt);

inline constexpr std::array<Move, 8> all{drop_parts,   drop_vertices, move_to_origin, rescale,
                                         simplify_one, look_straight, simplify_two,   round_all};

}  // namespace rayproof::shrink_moves
