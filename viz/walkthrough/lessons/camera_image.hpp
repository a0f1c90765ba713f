#pragma once
/// \file
/// The camera of the lessons on rays, and the image that it takes.

#include <rayproof/camera.hpp>

#include "viz/scene/items.hpp"

namespace rayproof::viz::camera_image {

[[nodiscard]] const rayproof::Camera<double>& eye();
inline constexpr int width = 8;
inline constexpr int height = 6;

/// Pixel (4, 2), as every step shows it.
inline constexpr int pixel_i = 4;
inline constexpr int pixel_j = 2;

/// A point of the image plane, at distance 1 from the eye; x and y from -1 to 1.
[[nodiscard]] glm::dvec3 on_image(double x, double y);

/// The image's frame and the lines between its pixels.
[[nodiscard]] Items grid();
[[nodiscard]] StageItem pixel(Role role, int i, int j);

/// Looks past the eye at its image, from this angle off the direction in which the eye looks.
[[nodiscard]] StageCamera behind_the_eye(double degrees);

}  // namespace rayproof::viz::camera_image
