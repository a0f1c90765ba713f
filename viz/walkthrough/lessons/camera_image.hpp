#pragma once
/// \file
/// The camera of the lessons on rays, and the image that it takes.

#include <cmath>
#include <glm/trigonometric.hpp>
#include <rayproof/camera.hpp>

#include "viz/scene/items.hpp"

namespace rayproof::viz::camera_image {

inline const rayproof::Camera<double> eye{{3.2, -2.4, 1.6}, {0, 0, 0.2}, {0, 0, 1}, 0.5, 0.375};
inline constexpr int width = 8;
inline constexpr int height = 6;

/// Pixel (4, 2), as every step shows it.
inline constexpr int pixel_i = 4;
inline constexpr int pixel_j = 2;

/// A point of the image plane, at distance 1 from the eye; x and y from -1 to 1.
[[nodiscard]] inline glm::dvec3 on_image(double x, double y) {
  const CameraAxes<double> axes = camera::axes(eye);
  return eye.eye + eye.half_width * x * axes.u + eye.half_height * y * axes.v - axes.w;
}

/// Of pixel (i, j), at the top left.
[[nodiscard]] inline glm::dvec3 corner_of(int i, int j) {
  return on_image(2.0 * i / width - 1, 1 - 2.0 * j / height);
}

/// The image's frame and the lines between its pixels.
[[nodiscard]] inline Items grid() {
  Items items;
  for (int i = 0; i <= width; ++i)
    items.push_back(segment(Role::frame, corner_of(i, 0), corner_of(i, height)));
  for (int j = 0; j <= height; ++j)
    items.push_back(segment(Role::frame, corner_of(0, j), corner_of(width, j)));
  items.push_back(polyline(Role::surface, {corner_of(0, 0), corner_of(width, 0), corner_of(width, height),
                                           corner_of(0, height), corner_of(0, 0)}));
  return items;
}

[[nodiscard]] inline StageItem pixel(Role role, int i, int j) {
  return polygon(role, {corner_of(i, j), corner_of(i + 1, j), corner_of(i + 1, j + 1), corner_of(i, j + 1)});
}

/// Looks past the eye at its image, from this angle off the direction in which the eye looks.
[[nodiscard]] inline StageCamera behind_the_eye(double degrees) {
  const glm::dvec3 back = camera::axes(eye).w;
  const double angle = std::atan2(back.y, back.x) - glm::radians(degrees);
  const glm::dvec3 toward = glm::normalize(glm::dvec3(std::cos(angle), std::sin(angle), 0.5));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), toward));
  return {right, glm::cross(toward, right), toward};
}

}  // namespace rayproof::viz::camera_image
