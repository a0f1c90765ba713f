/// \file
/// The batch kernels. Compiled once for each instruction set, with RAYPROOF_INSTRUCTION_SET naming the one it
/// is for.

#include "batch_kernels.hpp"

#include <rayproof/arithmetics/pack.hpp>

/// Puts all that a function calls into the function itself; not under AddressSanitizer, which would take
/// minutes.
#ifdef __SANITIZE_ADDRESS__
#define RAYPROOF_FLAT
#else
#define RAYPROOF_FLAT [[gnu::flatten]]
#endif

namespace rayproof::batch {

namespace {

constexpr bool is_baseline = InstructionSet::RAYPROOF_INSTRUCTION_SET == InstructionSet::baseline;

/// Every discriminant and both roots, computed in arithmetic `N`.
template <class Topic, class Method, class N, class T>
void all_roots(const Lanes<Topic, T>& in, T* const (&out)[3]) {
  with_assembler<Topic, N, T>(in, [&](const auto& assemble) {
    run<N>(in.columns, out, in.size, [&](const auto& columns, N(&to)[3]) {
      const Roots<N> roots = Topic::template solve<Method>(assemble(columns));
      to[0] = roots.discriminant;
      to[1] = roots.lo;
      to[2] = roots.hi;
    });
  });
}

/// Every nearest hit, computed in arithmetic `N`.
template <class Topic, class Method, class N, class T>
void nearest_roots(const Lanes<Topic, T>& in, T* const (&out)[1]) {
  with_assembler<Topic, N, T>(in, [&](const auto& assemble) {
    run<N>(in.columns, out, in.size, [&](const auto& columns, N(&to)[1]) {
      const auto problem = assemble(columns);
      to[0] = nearest(problem.ray, Topic::template solve<Method>(problem));
    });
  });
}

/// The same in packs, flat, since a pack that is handed to a function out of line goes through memory.
template <class Topic, class Method, class T>
RAYPROOF_FLAT void all_roots_in_packs(const Lanes<Topic, T>& in, T* const (&out)[3]) {
  all_roots<Topic, Method, Pack<T>, T>(in, out);
}
template <class Topic, class Method, class T>
RAYPROOF_FLAT void nearest_roots_in_packs(const Lanes<Topic, T>& in, T* const (&out)[1]) {
  nearest_roots<Topic, Method, Pack<T>, T>(in, out);
}

/// Enters a method's kernels. One number at a time gains nothing from a wider instruction set: that is the
/// baseline's.
template <class Topic, class Method, class T>
constexpr void enter(Kernels<Topic, Method, T>& kernels) {
  constexpr bool has_ray = RayProblem<typename Topic::template Problem<T>>;
  if constexpr (runs_in_packs<Method>) {
    kernels.roots = all_roots_in_packs<Topic, Method, T>;
    if constexpr (has_ray) kernels.nearest = nearest_roots_in_packs<Topic, Method, T>;
  } else if constexpr (is_baseline) {
    kernels.roots = all_roots<Topic, Method, T, T>;
    if constexpr (has_ray) kernels.nearest = nearest_roots<Topic, Method, T, T>;
  }
}

constexpr KernelTable built = [] {
  KernelTable table;
  std::apply([](auto&... kernels) { (enter(kernels), ...); }, table);
  return table;
}();

}  // namespace

template <>
const KernelTable& built_table<InstructionSet::RAYPROOF_INSTRUCTION_SET>() {
  return built;
}

}  // namespace rayproof::batch
