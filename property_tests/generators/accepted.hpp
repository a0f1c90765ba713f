#pragma once
/// \file
/// Draws again what the case format would refuse: rounding can make vectors dependent and a normal zero.

#include "case/accepted.hpp"

namespace rayproof {

/// The first of the questions from `draw()` that the format takes.
template <class Draw>
[[nodiscard]] RayQuestion first_accepted(Draw&& draw) {
  for (;;) {
    RayQuestion asked = draw();
    if (is_accepted(asked)) return asked;
  }
}

}  // namespace rayproof
