#pragma once
/// \file
/// Contenders over many rays at one shape: every method one ray at a time and in batches, GLM and the
/// floor.

#include <memory>

#include "bench/figures/shape_passes.hpp"

namespace rayproof::report {

template <class Methods, template <class> class Shape, class T>
[[nodiscard]] std::vector<Contender> ray_contenders_in(const std::vector<Case>& cases) {
  const auto rays = std::make_shared<ShapeRays<Shape, T>>(cases);
  std::vector<Contender> all;
  Methods::for_each([&]<class Method>(std::type_identity<Method>) {
    all.push_back({Method::name, Arrangement::scalar,
                   [rays](std::size_t count) { hit_one_by_one<Method>(*rays, count); }});
    all.push_back({Method::name, Arrangement::batch,
                   [rays](std::size_t count) { hit_in_batch<Method>(*rays, count); }});
  });
  // GLM's sphere is the one that is judged, too (subjects/).
  if constexpr (std::is_same_v<Shape<T>, Sphere<T>>)
    all.push_back({"glm", Arrangement::scalar, [rays](std::size_t count) { hit_by_glm(*rays, count); }});
  all.push_back(
      {BenchRow::floor_name, Arrangement::batch, [rays](std::size_t count) { only_stream(*rays, count); }});
  return all;
}

/// Of a shape's topic: `topic` says which shape.
template <class Methods, template <class> class Shape>
[[nodiscard]] std::vector<Contender> ray_contenders(const RayTopic<Shape>* /*topic*/,
                                                    const std::vector<Case>& cases, Precision precision) {
  return precision == Precision::float32 ? ray_contenders_in<Methods, Shape, float>(cases)
                                         : ray_contenders_in<Methods, Shape, double>(cases);
}

}  // namespace rayproof::report
