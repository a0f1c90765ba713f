#pragma once
/// \file
/// The passes over many rays that are timed: our kernels one by one and in batch, and the floor.

#include <rayproof/batch.hpp>
#include <span>

#include "bench/contenders/contender.hpp"
#include "bench/contenders/shape_rays.hpp"
#include "bench/streaming/streaming.hpp"

namespace rayproof::report {

/// The nearest hit of each of the first `count` rays, one at a time.
template <class Method, class Rays>
void hit_one_by_one(Rays& rays, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto ray = rays.ray(i);
    rays.t[i] = rays.space ? nearest(ray, roots_in_world<Method>(*rays.space, ray, rays.shape))
                           : nearest_hit<Method>(ray, rays.shape);
    one_at_a_time();
  }
}

/// The nearest hits of the first `count` rays by the batch kernel.
template <class Method, template <class> class Shape, class T>
void hit_in_batch(ShapeRays<Shape, T>& rays, std::size_t count, InstructionSet set) {
  const auto first = [count](const std::vector<T>& column) { return std::span(column).first(count); };
  const auto& c = rays.column;
  const RayBatch<T> batch{.origin = {first(c[0]), first(c[1]), first(c[2])},
                          .direction = {first(c[3]), first(c[4]), first(c[5])},
                          .object_space = rays.space};
  nearest_hits<Method>(batch, rays.shape, std::span(rays.t).first(count), set);
}

/// The floor: reads the six numbers of each ray, writes one.
template <template <class> class Shape, class T>
void only_stream(ShapeRays<Shape, T>& rays, std::size_t count, InstructionSet set) {
  const auto& c = rays.column;
  stream(Columns<T, 6, 1>{{c[0].data(), c[1].data(), c[2].data(), c[3].data(), c[4].data(), c[5].data()},
                          {rays.t.data()},
                          count},
         set);
}

}  // namespace rayproof::report
