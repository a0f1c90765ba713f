/// \file
/// The batch kernels: columns are read a pack at a time, made into problems, solved and written. Compiled
/// once for each instruction set, with RAYPROOF_INSTRUCTION_SET naming the one it is for.

#include <rayproof/batch/kernels.hpp>

#include "columns.hpp"

namespace rayproof::batch {

namespace {

/// One equation a lane.
template <class N, class T>
Quadratic<N> problem_of(const Lanes<Quadratic<T>>& /*in*/, const N (&column)[3]) {
  return {column[0], column[1], column[2]};
}

/// One ray a lane, with the common shape. What is common is kept as plain numbers: g++ 12 copies packs inside
/// structs in halves, which stalls; spreading a number anew costs nothing.
template <class N, template <class> class Shape, class T>
RayProblem<Shape, N> problem_of(const Lanes<RayProblem<Shape, T>>& in, const N (&column)[6]) {
  return {{{column[0], column[1], column[2]}, {column[3], column[4], column[5]}, N(in.t_min), N(in.t_max)},
          convert<N>(in.shape)};
}

/// Solves the problems in packs; flat, since a pack that is handed to a function out of line goes through
/// memory.
template <class Method, class Problem, class T, std::size_t Columns>
RAYPROOF_FLAT void solve(const Lanes<Problem>& given, T* const (&out)[Columns], bool all) {
  const Lanes<Problem> in = given;  // its own copy: nothing that is written can change it
  using N = Pack<T>;
  const auto fill = [&](const auto& columns, N(&to)[Columns]) {
    put_results<Method, Lanes<Problem>>(problem_of<N>(in, columns), to);
  };
  run<N>(in.columns, out, in.size, fill, all ? Columns : 1);
}

template <class T>
RAYPROOF_FLAT void move(const T* const (&in)[6], std::size_t size, const ObjectSpace<T>& given,
                        T* const (&out)[6]) {
  const ObjectSpace<T> space = given;
  using N = Pack<T>;
  run<N>(in, out, size, [&](const N(&c)[6], N(&to)[6]) {
    const Ray<N> ray = to_object(convert<N>(space), Ray<N>{{c[0], c[1], c[2]}, {c[3], c[4], c[5]}});
    const auto& [o, d, t_min, t_max] = ray;
    const N numbers[6] = {o.x, o.y, o.z, d.x, d.y, d.z};
    for (std::size_t i = 0; i < 6; ++i) to[i] = numbers[i];
  });
}

template <class Method, class Problem>
constexpr void enter(BatchKernel<Method, Problem>& kernel) {
  kernel.solve = solve<Method, Problem>;
}
template <class T>
constexpr void enter(ToObjectKernel<T>& kernel) {
  kernel.move = move<T>;
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
