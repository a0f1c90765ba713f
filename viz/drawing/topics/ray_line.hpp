#pragma once
/// \file
/// The ray in every picture: it runs to the right along y = 0.

#include <optional>

#include "viz/drawing/view.hpp"

namespace rayproof::viz {

/// Where the ray begins and ends on the picture's x axis; nothing where it has no such end.
struct RayLine {
  std::optional<Shadow> start{};
  std::optional<Shadow> end{};
};

/// The stretch of the line that is the ray, solid; the rest of the line, dotted; an arrow's head at its end.
void draw_ray_line(Picture& picture, const View& view, const RayLine& ray);

/// Where the start lies outside the view: its dot at the frame's side, beyond a break in the axis, with the
/// distance that it is off.
void draw_start_beyond(Picture& picture, const View& view, const RayLine& ray, const Shadow& distance);

}  // namespace rayproof::viz
