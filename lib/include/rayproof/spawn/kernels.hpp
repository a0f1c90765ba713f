#pragma once
/// \file
/// The compiled batch kernels for leaving surfaces, one table for each instruction set, as batch/kernels.hpp
/// has them for meeting shapes; batch.hpp beside this file calls them.

#include <rayproof/batch/instruction_set.hpp>
#include <rayproof/spawn/strategies.hpp>
#include <rayproof/spawn/surfaces.hpp>
#include <tuple>

namespace rayproof::spawn {

/// Hits on one surface: the columns x, y, z of their points, and of numbers that are negative where the next
/// ray leaves to the back.
template <class Surface, class T>
struct Hits {
  const T* columns[4];
  std::size_t size;
  Surface surface;
  bool is_moved;  ///< the points are in the world, the surface in its own space
  Placement<T> placement;
};

/// The strategies that have batch kernels.
using BatchedStrategies = TypeList<Proven>;

/// One strategy's kernel for one form of surface: writes the columns x, y, z of the origins.
template <class Strategy, template <class> class Surface, class T>
struct Kernel {
  void (*origins)(const Hits<Surface<T>, T>& hits, T* const (&out)[3]) = nullptr;
};

template <template <class> class Surface, class... Strategies>
auto kernels_of_surface(TypeList<Strategies...>)
    -> std::tuple<Kernel<Strategies, Surface, float>..., Kernel<Strategies, Surface, double>...>;
using KernelTable = decltype(std::tuple_cat(
    kernels_of_surface<Flat>(BatchedStrategies{}), kernels_of_surface<Sphere>(BatchedStrategies{}),
    kernels_of_surface<Box>(BatchedStrategies{}), kernels_of_surface<Slanted>(BatchedStrategies{}),
    kernels_of_surface<Cylinder>(BatchedStrategies{})));

/// The table that was compiled for an instruction set.
template <InstructionSet set>
const KernelTable& built_table();

/// The table built for an instruction set that is available.
[[nodiscard]] const KernelTable& kernel_table(InstructionSet set);

}  // namespace rayproof::spawn
