#pragma once
/// \file
/// What every batch kernel is made of: columns are read a pack at a time, made into problems, solved and
/// written.

#include <rayproof/batch/kernels.hpp>

namespace rayproof::batch {

/// The table of the kernels compiled for one instruction set.
template <InstructionSet set>
const KernelTable& built_table();

template <class N, class T>
[[nodiscard]] N load(const T* from) {
  if constexpr (std::same_as<N, T>) {
    return *from;
  } else {
    return N::load(from);
  }
}

template <class N, class T>
void store(const N& value, T* to) {
  if constexpr (std::same_as<N, T>) {
    *to = value;
  } else {
    value.store(to);
  }
}

template <class N, class T>
constexpr std::size_t width() {
  if constexpr (std::same_as<N, T>) {
    return 1;
  } else {
    return N::size;
  }
}

/// Calls `solve(in, out)` for every `width` lanes of the columns. The last lanes are padded with copies of
/// the very last one, so that they take the same path as all others.
template <class N, class T, std::size_t In, std::size_t Out, class Solve>
void run(const T* const (&in)[In], T* const (&out)[Out], std::size_t size, const Solve& solve) {
  constexpr std::size_t lanes = width<N, T>();
  N from[In];
  N to[Out];
  std::size_t i = 0;
  for (; i + lanes <= size; i += lanes) {
    for (std::size_t column = 0; column < In; ++column) from[column] = load<N>(in[column] + i);
    solve(from, to);
    for (std::size_t column = 0; column < Out; ++column) store(to[column], out[column] + i);
  }
  if (i == size) return;

  T padded[lanes];
  for (std::size_t column = 0; column < In; ++column) {
    for (std::size_t lane = 0; lane < lanes; ++lane)
      padded[lane] = in[column][i + lane < size ? i + lane : size - 1];
    from[column] = load<N>(padded);
  }
  solve(from, to);
  for (std::size_t column = 0; column < Out; ++column) {
    store(to[column], padded);
    for (std::size_t lane = 0; i + lane < size; ++lane) out[column][i + lane] = padded[lane];
  }
}

/// Makes equations of columns.
template <class Topic, class N, class T>
class EquationAssembler {
 public:
  explicit EquationAssembler(const QuadraticLanes<T>& /*in*/) {}

  [[nodiscard]] typename Topic::template Problem<N> operator()(const N (&column)[3]) const {
    return {{column[0], column[1], column[2]}};
  }
};

/// Makes rays of columns and intersects them with the common shape, in its own space if `is_moved`. What is
/// common is kept as plain numbers: g++ 12 copies packs inside structs in halves, which stalls; spreading a
/// number anew costs nothing.
template <class Topic, class N, class T, bool is_moved>
class RayAssembler {
 public:
  using Problem = typename Topic::template Problem<N>;
  using Shape = decltype(Topic::template Problem<T>::shape);

  explicit RayAssembler(const RayLanes<T, Shape>& in) : t_min_(in.t_min), t_max_(in.t_max), shape_(in.shape) {
    if constexpr (is_moved) space_ = *in.object_space;
  }

  [[nodiscard]] Problem operator()(const N (&column)[6]) const {
    const Ray<N> ray{
        {column[0], column[1], column[2]}, {column[3], column[4], column[5]}, N(t_min_), N(t_max_)};
    if constexpr (is_moved) {
      return {to_object(convert<N>(space_), ray), convert<N>(shape_)};
    } else {
      return {ray, convert<N>(shape_)};
    }
  }

 private:
  T t_min_, t_max_;
  Shape shape_;
  ObjectSpace<T> space_{};
};

/// Calls `solve(assembler)` with the assembler that suits the input.
template <class Topic, class N, class T, class Solve>
void with_assembler(const Lanes<Topic, T>& in, const Solve& solve) {
  if constexpr (!RayProblem<typename Topic::template Problem<N>>) {
    solve(EquationAssembler<Topic, N, T>(in));
  } else if (in.object_space != nullptr) {
    solve(RayAssembler<Topic, N, T, true>(in));
  } else {
    solve(RayAssembler<Topic, N, T, false>(in));
  }
}

}  // namespace rayproof::batch
