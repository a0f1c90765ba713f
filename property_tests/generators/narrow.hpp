#pragma once
/// \file
/// A polygon with a narrow slot or prong, and a point in it: what is near a side is then on no side's own
/// ground.

#include <cmath>

#include "generators/outline_layouts.hpp"

namespace rayproof::outline_layout {

inline constexpr Layout narrow{
    "narrow", "the point is in a slot or a prong whose width is 2^-4 to 2^-20 of its length", false,
    [](Random& random) -> PolygonCase {
      const double width = std::exp2(-random.uniform(4, 20)), left = random.uniform(-2, 2);
      const double length = random.one_in(2) ? random.uniform(1, 3) : -random.uniform(1, 3);
      Outline vertices{{-3, -4},       {3, -4},   {3, 0}, {left + width, 0}, {left + width, length},
                       {left, length}, {left, 0}, {-3, 0}};
      const double across = random.unit();
      Vec2<double> point{left + width * across, length * random.unit()};
      const double angle = random.uniform(0, 6.28), c = std::cos(angle), s = std::sin(angle);
      const auto turn = [c, s](Vec2<double>& v) { v = {c * v.x - s * v.y, s * v.x + c * v.y}; };
      turn(point);
      each_element(vertices, turn);
      return {point, vertices};
    }};

}  // namespace rayproof::outline_layout
