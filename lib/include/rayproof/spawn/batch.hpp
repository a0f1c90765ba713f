#pragma once
/// \file
/// Many hits on one surface left at once: bit for bit the scalar origins.

#include <optional>
#include <rayproof/batch.hpp>
#include <rayproof/spawn/kernels.hpp>

namespace rayproof::spawn {

/// One array for each coordinate, to be written.
template <class T>
struct OriginArrays {
  std::span<T> x, y, z;
};

/// The origins of the next rays from hits on one surface, of all shapes as `surface_of` gives them. `sides`
/// is negative where a ray leaves to the back. With a placement the hits are in the world. All arrays are of
/// one length, else std::invalid_argument is thrown.
template <class Strategy, template <class> class Surface, class T>
void next_origins(const Surface<T>& surface, const Coordinates<std::type_identity_t<T>>& hits,
                  std::type_identity_t<std::span<const T>> sides,
                  const OriginArrays<std::type_identity_t<T>>& origins,
                  const std::optional<Placement<std::type_identity_t<T>>>& placement = {},
                  InstructionSet set = preferred_instruction_set()) {
  const std::size_t size = batch::common_size(hits.x, hits.y, hits.z, sides, origins.x, origins.y, origins.z);
  using Entry = Kernel<Strategy, Surface, T>;
  static_assert(batch::is_in<Entry, KernelTable>,
                "this strategy has no batch kernels: call Strategy::origin in a loop instead");
  Hits<Surface<T>, T> in{{hits.x.data(), hits.y.data(), hits.z.data(), sides.data()},
                         size,
                         surface,
                         placement.has_value(),
                         placement.value_or(Placement<T>{})};
  if constexpr (can_be_placed<Surface<T>>) {
    if (placement) in.surface = place(surface, *placement);
    in.is_moved = false;
  }
  std::get<Entry>(kernel_table(set)).origins(in, {origins.x.data(), origins.y.data(), origins.z.data()});
}

}  // namespace rayproof::spawn
