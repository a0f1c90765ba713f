#pragma once
/// \file
/// The nearest hits of many rays among objects: in packs of rays, one object after the other.

#include <algorithm>
#include <array>
#include <cstdint>
#include <rayproof/batch.hpp>
#include <rayproof/objects/kernels.hpp>
#include <rayproof/objects/listed_object.hpp>

namespace rayproof {

/// In the place of an object's index: nothing is hit.
inline constexpr std::uint32_t no_object = UINT32_MAX;

namespace objects {

/// `size` rays of a batch, from the given one on.
template <class T>
[[nodiscard]] RayBatch<T> part_of(RayBatch<T> rays, std::size_t from, std::size_t size) {
  for (std::span<const T>* column : {&rays.origin.x, &rays.origin.y, &rays.origin.z, &rays.direction.x,
                                     &rays.direction.y, &rays.direction.z})
    *column = column->subspan(from, size);
  for (std::span<const T>* column : {&rays.each_t_min, &rays.each_t_max})
    if (!column->empty()) *column = column->subspan(from, size);
  return rays;
}

/// The nearest hit of each ray with one object, as nearest_hits() has it of a shape.
template <class Choice, class Topic, class Shape, class T>
void nearest_hits_of(const ListedObject<Topic, Shape, T>& object, RayBatch<T>& rays, std::span<T> t,
                     InstructionSet set) {
  if constexpr (is_batched<Topic>) {
    rays.object_space = object.space;
    nearest_hits<typename Choice::template method<Topic>>(rays, object.shape, t, set);
  } else {
    rays.object_space.reset();
    const auto problems = batch::lanes_of(rays, object.shape);
    for (std::size_t i = 0; i < t.size(); ++i) {
      const Ray<T> ray = batch::problem_at(problems, i).ray;
      t[i] = rayproof::nearest(ray, object.template roots<Choice>(ray));
    }
  }
}

/// The nearest hit of each ray: its t, infinity for a miss, and the object's index, `no_object` for a miss;
/// of several at one t that of the least index. Some hundred rays at a time, so that they stay in the
/// processor's nearest cache. `for_each(meet)` calls `meet` with every object.
template <class Choice, class T, class ForEach>
void nearest_of_many(const RayBatch<T>& rays, std::span<T> t, std::span<std::uint32_t> index,
                     InstructionSet set, const ForEach& for_each) {
  const std::size_t size = batch::common_size(rays.origin.x, t, index);
  if (rays.object_space) throw std::invalid_argument("the objects of a list have matrices of their own");
  std::ranges::fill(t, infinity<T>);
  std::ranges::fill(index, no_object);
  const auto& kernel = std::get<KeepNearerKernel<T>>(kernel_table(set));
  std::array<T, batch::quick_block> own;
  for (std::size_t from = 0; from < size; from += own.size()) {
    const std::size_t count = std::min(own.size(), size - from);
    RayBatch<T> part = part_of(rays, from, count);
    for_each([&](const auto& object) {
      nearest_hits_of<Choice>(object, part, std::span<T>(own.data(), count), set);
      kernel.keep(own.data(), static_cast<std::uint32_t>(object.index), count, &t[from], &index[from]);
      return T(0);
    });
  }
}

}  // namespace objects

}  // namespace rayproof
