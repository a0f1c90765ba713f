#pragma once
/// \file
/// Other people's libraries beside our methods: each routine timed over many rays, and judged by the oracle.

#include <memory>
#include <optional>
#include <rayproof/transform.hpp>

#include "bench/contenders/contender.hpp"
#include "bench/contenders/shape_rays.hpp"

namespace rayproof::report {

/// A library's routine for one shape.
struct PeerRoutine {
  Subject subject{};
  /// Whether the routine can be asked: of t in [0, ∞] alone, and nothing that the library excludes. Where it
  /// cannot, the case is left out.
  bool (*takes)(const Case&) = nullptr;
  std::vector<Contender> (*contenders)(const std::string& library, const std::vector<Case>& cases) = nullptr;
  std::size_t most_cases = 16'384;  ///< that are judged
};

/// Those that were built in, for one topic and precision.
[[nodiscard]] std::vector<PeerRoutine> peers_of(const std::string& topic, Precision precision);

/// What they are timed by; a routine that can't be asked any of the cases is left out.
[[nodiscard]] std::vector<Contender> peer_contenders(const std::string& topic, const std::vector<Case>& cases,
                                                     Precision precision);

[[nodiscard]] std::vector<PeerRoutine> glm_peers();
[[nodiscard]] std::vector<PeerRoutine> cgal_peers();
[[nodiscard]] std::vector<PeerRoutine> vtk_peers();
[[nodiscard]] std::vector<PeerRoutine> embree_peers();

/// A `Routine<T>` is made of the shape. `prepared(ray)` makes of a ray what the library asks for, where it
/// can; `nearest(prepared)` is what is timed; `t_of(prepared, nearest)` says what that means, infinity being
/// a miss.
template <class Routine, class T, template <class> class Shape>
[[nodiscard]] Answer answer_by_routine(const Case& one) {
  const auto [ray, shape] = Reading<RayTopic<Shape>>::template problem<T>(one);
  RayAnswer answer;
  answer.nearest_only = true;
  const Routine routine(shape);
  const auto prepared = routine.prepared(ray);
  if (!prepared) return answer;
  const auto t = static_cast<T>(routine.t_of(*prepared, routine.nearest(*prepared)));
  if (!std::isfinite(t) || !in_interval(ray, t)) return answer;
  answer.contact = Contact::crossing;
  answer.hits.push_back(static_cast<double>(t));
  return answer;
}

template <class Routine, class T, template <class> class Shape>
[[nodiscard]] bool is_taken_by_routine(const Case& one) {
  const auto [ray, shape] = Reading<RayTopic<Shape>>::template problem<T>(one);
  const bool has_interval = ray.t_min != 0 || ray.t_max != infinity<T>;
  return !has_interval && Routine(shape).prepared(ray).has_value();
}

/// One ray at a time. Without a transform the rays were prepared beforehand, at no cost to the library; with
/// one, that can only be done after the ray has been transformed. Where a ray can't be asked, the last one
/// that can stands in.
template <class Routine, class T, template <class> class Shape>
[[nodiscard]] std::vector<Contender> time_routine(const std::string& library,
                                                  const std::vector<Case>& cases) {
  const auto rays = std::make_shared<ShapeRays<Shape, T>>(cases);
  const auto in_space = [rays](std::size_t i) {
    return rays->space ? to_object(*rays->space, rays->ray(i)) : rays->ray(i);
  };
  const auto routine = std::make_shared<const Routine>(rays->shape);
  using Prepared = typename decltype(routine->prepared(rays->ray(0)))::value_type;
  const auto prepared = std::make_shared<std::vector<Prepared>>();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (const auto one = routine->prepared(in_space(i)))
      prepared->resize(i + 1, *one);
    else if (!prepared->empty())
      prepared->push_back(prepared->back());
  }
  if (prepared->empty()) return {};
  const auto pass = [=](std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (rays->space)
        if (const auto one = routine->prepared(in_space(i))) (*prepared)[i] = *one;
      rays->t[i] = static_cast<T>(routine->nearest((*prepared)[i]));
      one_at_a_time();
    }
  };
  return {{library, Arrangement::scalar, pass}};
}

/// A peer whose routine computes in T.
template <class Routine, class T, template <class> class Shape>
[[nodiscard]] PeerRoutine peer_by(const char* topic, const char* library) {
  PeerRoutine peer{.takes = is_taken_by_routine<Routine, T, Shape>,
                   .contenders = time_routine<Routine, T, Shape>};
  peer.subject.topic = topic;
  peer.subject.name = library;
  peer.subject.precisions = {std::is_same_v<T, float> ? Precision::float32 : Precision::float64};
  peer.subject.answer_by(answer_by_routine<Routine, T, Shape>);
  return peer;
}

}  // namespace rayproof::report
