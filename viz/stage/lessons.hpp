#pragma once
/// \file
/// The lessons by group; a new group is a function here and a line in lesson.cpp.

#include "viz/stage/lesson.hpp"

namespace rayproof::viz {

[[nodiscard]] std::vector<Lesson> sphere_lessons();

}  // namespace rayproof::viz
