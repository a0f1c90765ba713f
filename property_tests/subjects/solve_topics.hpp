#pragma once
/// \file
/// The readings of the topics that have one of their own: planes, whose misses have something to say, and
/// what is no ray.

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
    constexpr bool distinguishes = !requires { Method::calls_in_plane_parallel; };
    return is_inside && distinguishes ? Contact::in_surface : Contact::parallel;
  }
};

template <>
struct Reading<plane::Topic> : RayReading<plane::Topic, PlaneMiss> {};

template <>
struct Reading<quadratic::Topic> {
  template <class A>
  [[nodiscard]] static quadratic::Topic::Problem<A> problem(const Case& one) {
    return convert<A>(convert<Plain<A>>(std::get<Quadratic<double>>(one.question)));
  }

  template <class Method, class T>
  [[nodiscard]] static Roots<T> batch_roots(const Case& one) {
    return batch::roots_among_neighbours<Method>(problem<T>(one));
  }

  template <class Method, class T>
  [[nodiscard]] static QuadraticAnswer<double> answer(const Case& one, const Roots<T>& roots) {
    const QuadraticAnswer<T> narrow = read(problem<T>(one), roots);
    return {narrow.kind,
            narrow.count,
            {static_cast<double>(narrow.roots[0]), static_cast<double>(narrow.roots[1])}};
  }
};

template <>
struct Reading<point_in_polygon::Topic> {
  template <class A>
  [[nodiscard]] static point_in_polygon::Topic::Problem<A> problem(const Case& one) {
    return convert<A>(std::get<PointAndPolygon<double>>(one.question));
  }

  template <class Method, class T>
  [[nodiscard]] static Position answer(const Case& /*one*/, Position position) {
    return position;
  }
};

}  // namespace rayproof
