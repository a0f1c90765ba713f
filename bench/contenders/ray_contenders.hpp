#pragma once
/// \file
/// Contenders over many rays at one shape: every method one ray at a time and in batches, and the
/// floor.

#include <memory>

#include "bench/contenders/shape_passes.hpp"

namespace rayproof::report {

template <class Methods, template <class> class Shape, class T>
[[nodiscard]] std::vector<Contender> ray_contenders_in(const std::vector<Case>& cases,
                                                       const std::vector<InstructionSet>& sets) {
  const auto rays = std::make_shared<ShapeRays<Shape, T>>(cases);
  std::vector<Contender> all;
  Methods::for_each([&]<class Method>(std::type_identity<Method>) {
    all.push_back({Method::name, Arrangement::scalar,
                   [rays](std::size_t count) { hit_one_by_one<Method>(*rays, count); }});
    for (const InstructionSet set : sets)
      all.push_back({Method::name, Arrangement::batch,
                     [rays, set](std::size_t count) { hit_in_batch<Method>(*rays, count, set); }, set});
  });
  for (const InstructionSet set : sets)
    all.push_back({floor_name, Arrangement::batch,
                   [rays, set](std::size_t count) { only_stream(*rays, count, set); }, set});
  return all;
}

/// Of a shape's topic: `topic` says which shape.
template <class Methods, template <class> class Shape>
[[nodiscard]] std::vector<Contender> ray_contenders(const RayTopic<Shape>* /*topic*/,
                                                    const std::vector<Case>& cases, Precision precision,
                                                    const std::vector<InstructionSet>& sets) {
  return precision == Precision::float32 ? ray_contenders_in<Methods, Shape, float>(cases, sets)
                                         : ray_contenders_in<Methods, Shape, double>(cases, sets);
}

}  // namespace rayproof::report
