#pragma once

namespace rayproof {

/// A point or vector of the plane.
template <class T>
struct Vec2 {
  T x, y;
};

}  // namespace rayproof
