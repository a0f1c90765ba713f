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

/// The case of the lessons: that pixel's ray, and the first sphere that it may meet.
inline constexpr const char* case_text =
    R"({"precision": "float32", "ray": {"origin": [3.2, -2.4, 1.6], "direction": [-0.734104156, 0.628703117, -0.271359265]},
        "shape": {"type": "sphere", "center": [0, 0, 0.2], "radius": 0.75}})";

/// A point of the image plane, at distance 1 from the eye; x and y from -1 to 1.
[[nodiscard]] glm::dvec3 on_image(double x, double y);

/// The image's frame and the lines between its pixels.
[[nodiscard]] Items grid();
[[nodiscard]] StageItem pixel(Role role, int i, int j);

/// Looks past the eye at its image, from this angle off the direction in which the eye looks.
[[nodiscard]] StageCamera behind_the_eye(double degrees);

}  // namespace rayproof::viz::camera_image
