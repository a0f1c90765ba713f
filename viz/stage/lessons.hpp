#pragma once
/// \file
/// The lessons by group; a new group is a function here and a line in lesson.cpp.

#include "viz/stage/lesson.hpp"

namespace rayproof::viz {

[[nodiscard]] std::vector<Lesson> ray_lessons();
[[nodiscard]] std::vector<Lesson> camera_lessons();
[[nodiscard]] std::vector<Lesson> raycasting_lessons();
[[nodiscard]] std::vector<Lesson> plane_lessons();
[[nodiscard]] std::vector<Lesson> triangle_lessons();
[[nodiscard]] std::vector<Lesson> polygon_lessons();
[[nodiscard]] std::vector<Lesson> quadratic_lessons();
[[nodiscard]] std::vector<Lesson> sphere_lessons();
[[nodiscard]] std::vector<Lesson> solid_lessons();
[[nodiscard]] std::vector<Lesson> transform_lessons();
[[nodiscard]] std::vector<Lesson> barycentric_lessons();
[[nodiscard]] std::vector<Lesson> slab_interval_lessons();
[[nodiscard]] std::vector<Lesson> digit_lessons();
[[nodiscard]] std::vector<Lesson> leak_lessons();

}  // namespace rayproof::viz
