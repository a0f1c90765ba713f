/// \file
/// The batch kernels: columns are read a pack at a time, made into problems, solved and written. Compiled
/// once for each instruction set, with RAYPROOF_INSTRUCTION_SET naming the one it is for.

#include <rayproof/batch/kernels.hpp>

#include "columns.hpp"

namespace rayproof::batch {

namespace {

constexpr bool is_baseline = InstructionSet::RAYPROOF_INSTRUCTION_SET == InstructionSet::baseline;

/// One equation a lane.
template <bool is_moved, class N, class T>
Quadratic<N> problem_of(const Lanes<Quadratic<T>>& /*in*/, const N (&column)[3]) {
  return {column[0], column[1], column[2]};
}

/// One ray a lane, with the common shape, in its own space if `is_moved`. What is common is kept as plain
/// numbers: g++ 12 copies packs inside structs in halves, which stalls; spreading a number anew costs
/// nothing.
template <bool is_moved, class N, template <class> class Shape, class T>
RayProblem<Shape, N> problem_of(const Lanes<RayProblem<Shape, T>>& in, const N (&column)[6]) {
  const Ray<N> ray{
      {column[0], column[1], column[2]}, {column[3], column[4], column[5]}, N(in.t_min), N(in.t_max)};
  if constexpr (is_moved) {
    return {to_object(convert<N>(in.object_space), ray), convert<N>(in.shape)};
  } else {
    return {ray, convert<N>(in.shape)};
  }
}

/// Writes every discriminant and both roots, or into one column every nearest hit, computed in arithmetic
/// `N`.
template <class Method, class N, class Problem, std::size_t Columns>
void fill(const Lanes<Problem>& given, Plain<N>* const (&out)[Columns]) {
  const Lanes<Problem> in = given;  // its own copy: nothing that is written can change it
  const auto solve_all = [&]<bool is_moved>(std::bool_constant<is_moved>) {
    run<N>(in.columns, out, in.size, [&](const auto& columns, N(&to)[Columns]) {
      const auto problem = problem_of<is_moved>(in, columns);
      const Roots<N> roots = Lanes<Problem>::Topic::template solve<Method>(problem);
      if constexpr (Columns == 1) {
        to[0] = nearest(problem.ray, roots);
      } else {
        to[0] = roots.discriminant;
        to[1] = roots.lo;
        to[2] = roots.hi;
      }
    });
  };
  if constexpr (requires { in.is_moved; }) {
    if (in.is_moved) return solve_all(std::true_type{});
  }
  solve_all(std::false_type{});
}

/// The same in packs, flat, since a pack that is handed to a function out of line goes through memory.
template <class Method, class Problem, class T, std::size_t Columns>
RAYPROOF_FLAT void fill_in_packs(const Lanes<Problem>& in, T* const (&out)[Columns]) {
  fill<Method, Pack<T>>(in, out);
}

/// Enters a method's kernels. One number at a time gains nothing from a wider instruction set: that is the
/// baseline's.
template <class Method, class Problem>
constexpr void enter(Kernels<Method, Problem>& kernels) {
  using T = typename Lanes<Problem>::Number;
  constexpr bool has_ray = requires(Problem problem) { problem.ray; };
  if constexpr (runs_in_packs<Method>) {
    kernels.roots = fill_in_packs<Method, Problem, T, 3>;
    if constexpr (has_ray) kernels.nearest = fill_in_packs<Method, Problem, T, 1>;
  } else if constexpr (is_baseline) {
    kernels.roots = fill<Method, T, Problem, 3>;
    if constexpr (has_ray) kernels.nearest = fill<Method, T, Problem, 1>;
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
