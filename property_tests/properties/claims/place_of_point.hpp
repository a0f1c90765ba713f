#pragma once
/// \file
/// Which of the line's hits a point belongs to that a guest gives without t.

#include "properties/trial.hpp"

namespace rayproof {

/// How far a point without t lies at another of the line's hits than the nearest in the interval, in parts of
/// what rounding excuses: more than 1 is wrong. 0 where it belongs to the nearest one, and where t is given.
[[nodiscard]] double excess_of_place(Trial& trial);

}  // namespace rayproof
