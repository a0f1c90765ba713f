/// \file
/// The batch kernels for leaving surfaces. Compiled once for each instruction set, with
/// RAYPROOF_INSTRUCTION_SET naming the one it is for.

#include <rayproof/spawn/kernels.hpp>

#include "columns.hpp"

namespace rayproof::spawn {

namespace {

/// In packs, flat, since a pack that is handed to a function out of line goes through memory. What the hits
/// have in common is spread anew for each pack, as in batch_kernels.cpp.
template <class Strategy, template <class> class Surface, class T>
RAYPROOF_FLAT void fill(const Hits<Surface<T>, T>& given, T* const (&out)[3]) {
  using N = Pack<T>;
  const Hits<Surface<T>, T> in = given;  // its own copy: nothing that is written can change it
  const auto write = [](SurfacePoint<N>& from, const N& side, N(&to)[3]) {
    turn(from, side);
    const vec3<N> origin = Strategy::origin(from);
    to[0] = origin.x;
    to[1] = origin.y;
    to[2] = origin.z;
  };
  if constexpr (!can_be_placed<Surface<T>>) {
    if (in.is_moved) {
      batch::run<N>(in.columns, out, in.size, [&](const N(&hit)[4], N(&to)[3]) {
        const vec3<N> p{hit[0], hit[1], hit[2]};
        SurfacePoint<N> from = leave(convert<N>(in.surface), convert<N>(in.placement), p);
        write(from, hit[3], to);
      });
      return;
    }
  }
  batch::run<N>(in.columns, out, in.size, [&](const N(&hit)[4], N(&to)[3]) {
    SurfacePoint<N> from = leave(convert<N>(in.surface), vec3<N>{hit[0], hit[1], hit[2]});
    write(from, hit[3], to);
  });
}

template <class Strategy, template <class> class Surface, class T>
constexpr void enter(Kernel<Strategy, Surface, T>& kernel) {
  kernel.origins = fill<Strategy, Surface, T>;
}

constexpr KernelTable built = batch::filled<KernelTable>([](auto& kernel) { enter(kernel); });

}  // namespace

template <>
const KernelTable& built_table<InstructionSet::RAYPROOF_INSTRUCTION_SET>() {
  return built;
}

}  // namespace rayproof::spawn
