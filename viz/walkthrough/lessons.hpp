#pragma once
/// \file
/// The registration of the lessons: each group's function, and its line in the order of teaching.

#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {

// Each in lessons/NAME.cpp or lessons/numbers/NAME.cpp.
[[nodiscard]] std::vector<Lesson> ray_lessons();
[[nodiscard]] std::vector<Lesson> camera_lessons();
[[nodiscard]] std::vector<Lesson> raycasting_lessons();
[[nodiscard]] std::vector<Lesson> plane_lessons();
[[nodiscard]] std::vector<Lesson> triangle_lessons();
[[nodiscard]] std::vector<Lesson> polygon_lessons();
[[nodiscard]] std::vector<Lesson> polygon_in_space_lessons();
[[nodiscard]] std::vector<Lesson> segment_lessons();
[[nodiscard]] std::vector<Lesson> quadratic_lessons();
[[nodiscard]] std::vector<Lesson> sphere_lessons();
[[nodiscard]] std::vector<Lesson> solid_lessons();
[[nodiscard]] std::vector<Lesson> transform_lessons();
[[nodiscard]] std::vector<Lesson> barycentric_lessons();
[[nodiscard]] std::vector<Lesson> slab_interval_lessons();
[[nodiscard]] std::vector<Lesson> digit_lessons();
[[nodiscard]] std::vector<Lesson> leak_lessons();
[[nodiscard]] std::vector<Lesson> leaving_lessons();
[[nodiscard]] std::vector<Lesson> printed_lessons();
[[nodiscard]] std::vector<Lesson> surface_lessons();
[[nodiscard]] std::vector<Lesson> acne_lessons();
[[nodiscard]] std::vector<Lesson> error_map_lessons();
[[nodiscard]] std::vector<Lesson> property_test_lessons();

inline constexpr std::vector<Lesson> (*lesson_groups[])() = {
    ray_lessons,               //
    camera_lessons,            //
    raycasting_lessons,        //
    plane_lessons,             //
    triangle_lessons,          //
    polygon_lessons,           //
    polygon_in_space_lessons,  //
    segment_lessons,           //
    quadratic_lessons,         //
    sphere_lessons,            //
    solid_lessons,             //
    transform_lessons,         //
    barycentric_lessons,       //
    slab_interval_lessons,     //
    digit_lessons,             //
    leak_lessons,              //
    leaving_lessons,           //
    acne_lessons,              //
    error_map_lessons,         //
    property_test_lessons,     //
    surface_lessons,           //
    printed_lessons,           //
};

}  // namespace rayproof::viz
