#pragma once
/// \file
/// How a batch is solved: by the compiled kernel, or problem by problem; rays of the world are taken into the
/// object's space before.

#include <algorithm>
#include <optional>
#include <rayproof/batch/kernels.hpp>
#include <rayproof/formulas/bounded_roots.hpp>

namespace rayproof::batch {

/// `size` problems of a batch, from the given one on.
template <class Problem>
[[nodiscard]] Lanes<Problem> part_of(Lanes<Problem> in, std::size_t from, std::size_t size) {
  for (auto& column : in.columns)
    if (column != nullptr) column += from;
  in.size = size;
  return in;
}

/// One problem of a batch.
template <class T>
[[nodiscard]] Quadratic<T> problem_at(const Lanes<Quadratic<T>>& in, std::size_t i) {
  return {in.columns[0][i], in.columns[1][i], in.columns[2][i]};
}
template <template <class> class Shape, class T>
[[nodiscard]] RayProblem<Shape, T> problem_at(const Lanes<RayProblem<Shape, T>>& in, std::size_t i) {
  const auto& c = in.columns;
  const auto end = [&](std::size_t which) {
    return c[6 + which] == nullptr ? in.interval[which] : c[6 + which][i];
  };
  return {{{c[0][i], c[1][i], c[2][i]}, {c[3][i], c[4][i], c[5][i]}, end(0), end(1)}, in.shape};
}

/// Answers one problem of a batch by `solve(problem)`.
template <class Problem, class T, std::size_t Columns, class Solve>
void solve_one(const Lanes<Problem>& in, std::size_t i, T* const (&out)[Columns], bool all,
               const Solve& solve) {
  T results[Columns];
  const Problem problem = problem_at(in, i);
  put_results<Lanes<Problem>>(problem, solve(problem), results);
  for (std::size_t column = 0; column < (all ? Columns : 1); ++column) out[column][i] = results[column];
}
/// Runs a kernel with a quick phase, `run(part, results)`, some hundred problems at a time, and answers those
/// that it is in doubt of, which it left NaN, by `solve(problem)`, while they are in the processor's nearest
/// cache.
template <class Problem, class T, std::size_t Columns, class Run, class Solve>
void run_quick_kernel(const Lanes<Problem>& in, T* const (&out)[Columns], bool all, const Run& run,
                      const Solve& solve) {
  for (std::size_t from = 0; from < in.size; from += quick_block) {
    const auto part = part_of(in, from, std::min(quick_block, in.size - from));
    T* results[Columns] = {};
    for (std::size_t i = 0; i < (all ? Columns : 1); ++i) results[i] = out[i] + from;
    if (!run(part, results)) continue;
    const T* const marked = results[all ? Columns - 3 : 0];  // the discriminant, or the nearest hit
    for (std::size_t i = 0; i < part.size; ++i) {
      if (marked[i] != marked[i]) solve_one(part, i, results, all, solve);
    }
  }
}

/// Runs the method's kernel, which fills these columns, or the first alone.
template <class Method, class Problem, class T, std::size_t Columns>
void run_kernel(InstructionSet set, const Lanes<Problem>& in, T* const (&out)[Columns], bool all) {
  const auto solve = [](const Problem& one) { return Lanes<Problem>::Topic::template solve<Method>(one); };
  if constexpr (has_kernels<Method>) {
    const auto& kernel = std::get<BatchKernel<Method, Problem>>(kernel_table(set));
    const auto run = [&](const auto& part, const auto& results) { return kernel.solve(part, results, all); };
    if constexpr (has_quick_phase<Method>) {
      run_quick_kernel(in, out, all, run, solve);
    } else {
      run(in, out);
    }
  } else {
    for (std::size_t i = 0; i < in.size; ++i) solve_one(in, i, out, all, solve);
  }
}

/// The same for rays that are in the world, by a method that takes the transform itself.
template <class Method, class Problem, class T>
void solve_in_world([[maybe_unused]] InstructionSet set, const Lanes<Problem>& in,
                    const ObjectSpace<T>& space, T* const (&out)[6], bool all) {
  const auto one_by_one = [&](const auto& solve) {
    for (std::size_t i = 0; i < in.size; ++i) solve_one(in, i, out, all, solve);
  };
  if constexpr (has_quick_phase_in_world<Method>) {
    const auto bounded = bounded_space(space);
    const auto solve = [&](const Problem& one) {
      return quick_or_exact_roots<Method>(space, bounded, one.ray, one.shape);
    };
    if constexpr (has_kernel_in_world<Method, T>) {
      const auto& kernel = std::get<BatchKernel<Method, Problem>>(kernel_table(set));
      const auto run = [&](const auto& part, const auto& results) {
        return kernel.solve_in_world(part, bounded, results, all);
      };
      run_quick_kernel(in, out, all, run, solve);
    } else {
      one_by_one(solve);
    }
  } else {
    one_by_one([&](const Problem& one) { return Method::roots_in_world(space, one.ray, one.shape); });
  }
}

/// The same for rays that are in the world: they are taken into the object's space first, some hundred at a
/// time, so that they stay in the processor's nearest cache.
template <class Method, class Problem, class T>
void run_in_space(InstructionSet set, const Lanes<Problem>& in, const ObjectSpace<T>& space,
                  T* const (&out)[6], bool all) {
  constexpr std::size_t block = 256;
  T moved[6][block];
  T* const to[6] = {moved[0], moved[1], moved[2], moved[3], moved[4], moved[5]};
  const auto& kernel = std::get<ToObjectKernel<T>>(kernel_table(set));
  for (std::size_t from = 0; from < in.size; from += block) {
    auto part = part_of(in, from, std::min(block, in.size - from));
    const auto& [x, y, z, dx, dy, dz, t_min, t_max] = part.columns;
    kernel.move({x, y, z, dx, dy, dz}, part.size, space, to);
    T* results[6] = {};
    for (std::size_t i = 0; i < 6; ++i) {
      part.columns[i] = to[i];
      if (all || i == 0) results[i] = out[i] + from;
    }
    run_kernel<Method>(set, part, results, all);
  }
}

/// Solves a batch of problems, given as columns. A method that answers no such batch is refused here, in one
/// sentence, before it is looked for in the tables.
template <class Method, class Problem, class T, std::size_t Columns>
void solve(InstructionSet set, const Lanes<Problem>& in, T* const (&out)[Columns], bool all,
           [[maybe_unused]] const std::optional<ObjectSpace<T>>& space = {}) {
  static_assert(answers_batches<Method, Problem>,
                "this method answers no batches of this input: call Method::roots in a loop instead");
  if constexpr (answers_batches<Method, Problem>) {
    if constexpr (Columns == 6) {
      if (space) {
        if constexpr (takes_transforms<Method, T, decltype(in.shape)>)
          return solve_in_world<Method>(set, in, *space, out, all);
        else
          return run_in_space<Method>(set, in, *space, out, all);
      }
    }
    run_kernel<Method>(set, in, out, all);
  }
}

}  // namespace rayproof::batch
