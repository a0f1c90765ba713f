#pragma once
/// \file
/// The readings of all shapes: `RayReading`, and what a miss of a plane has to say.

#include <rayproof/topics.hpp>

#include "subjects/solve_ray.hpp"

namespace rayproof {

/// Every topic but those that read questions of their own is a shape's.
template <class Topic>
struct Reading : RayReading<Topic, PlainMiss> {};

/// A ray misses a plane because it is parallel to it, or runs inside it.
struct PlaneMiss {
  template <class Method, class T>
  [[nodiscard]] static Contact contact(const plane::Topic::Problem<T>& asked) {
    const auto [normal, d] = plane::as_implicit(asked.shape);
    if (dot(normal, asked.ray.direction) != 0) return Contact::none;
    const bool is_inside = dot(normal, asked.ray.origin) + d == 0;
    constexpr bool tells_apart = !requires { Method::calls_in_plane_parallel; };
    return is_inside && tells_apart ? Contact::in_surface : Contact::parallel;
  }
};

template <>
struct Reading<plane::Topic> : RayReading<plane::Topic, PlaneMiss> {};

}  // namespace rayproof
