#pragma once
/// \file
/// The readings of the shapes, one line each but where a miss has something to say.

#include <rayproof/topics.hpp>

#include "subjects/solve_ray.hpp"

namespace rayproof {

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
template <>
struct Reading<triangle::Topic> : RayReading<triangle::Topic, PlainMiss> {};
template <>
struct Reading<polygon::Topic> : RayReading<polygon::Topic, PlainMiss> {};
template <>
struct Reading<sphere::Topic> : RayReading<sphere::Topic, PlainMiss> {};
template <>
struct Reading<box::Topic> : RayReading<box::Topic, PlainMiss> {};
template <>
struct Reading<parallelepiped::Topic> : RayReading<parallelepiped::Topic, PlainMiss> {};
template <>
struct Reading<cylinder::Topic> : RayReading<cylinder::Topic, PlainMiss> {};

}  // namespace rayproof
