#pragma once
/// \file
/// What kernels name in plain floating point.

#include <rayproof/topics.hpp>

#include "unit/viz/walkthrough/stage_bits/heard.hpp"
#include "viz/shapes/ray_walk.hpp"

namespace rayproof::viz {

using NamedNumbers = std::vector<std::pair<std::string, double>>;

/// The problem that a case puts, in an arithmetic that hears names: only the kernel's own are left.
template <class Topic, class H>
typename Topic::template Problem<H> heard_problem(const Case& one) {
  if constexpr (std::is_same_v<Topic, quadratic::Topic>) {
    H::names.clear();
    return convert<H>(std::get<Quadratic<double>>(one.question));
  } else {
    const auto& question = std::get<RayQuestion>(one.question);
    using Shape = decltype(Topic::template Problem<H>::shape);
    const auto shape = recorded_shape<Shape, H>(question);
    H::names.clear();
    if (!question.transform) return {convert<H>(question.ray), shape};
    const auto ray = in_object_space<H>(convert<H>(question.ray), *question.transform, Topic::name);
    H::names.erase(H::names.begin(), H::names.begin() + 12);  // the map's columns are inputs
    return {ray, shape};
  }
}

/// What a method's kernel names in plain T.
template <class Topic, class T>
NamedNumbers heard_in(const Case& one, const std::string& method) {
  using H = Heard<T>;
  NamedNumbers names;
  if constexpr (!std::is_same_v<Topic, point_in_polygon::Topic>) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      if constexpr (Recordable<Method, H>) {
        if (method != std::string(Topic::name) + "/" + Method::name) return;
        (void)Topic::template solve<Method>(heard_problem<Topic, H>(one));
        names = H::names;
      }
    });
  }
  return names;
}

[[nodiscard]] inline NamedNumbers heard(const Case& one, const std::string& method) {
  NamedNumbers names;
  Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
    if (Topic::name != topic_of(one)) return;
    names = one.precision == Precision::float32 ? heard_in<Topic, float>(one, method)
                                                : heard_in<Topic, double>(one, method);
  });
  return names;
}

}  // namespace rayproof::viz
