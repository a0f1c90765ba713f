#pragma once
/// \file
/// The compiled kernels for one ray and many objects of a shape, one table for each instruction set, as
/// batch/kernels.hpp has them for many rays and one shape; object_group.hpp and many_rays.hpp call them.

#include <cstddef>
#include <cstdint>
#include <rayproof/batch/kernels.hpp>
#include <tuple>

namespace rayproof::objects {

/// As many shapes as the widest pack has lanes are a block.
inline constexpr std::size_t lanes = 16;

/// One ray and blocks of shapes. A block has `lanes` times the first number of a shape, then as often the
/// second, in the order of its members; after them, of shapes under a matrix, the numbers of their
/// ObjectSpace.
template <class Problem>
struct Many;
template <template <class> class Shape, class T>
struct Many<RayProblem<Shape, T>> {
  using Number = T;
  static constexpr std::size_t shape_numbers = sizeof(Shape<T>) / sizeof(T);
  static constexpr std::size_t space_numbers = sizeof(ObjectSpace<T>) / sizeof(T);
  const T* numbers;
  std::size_t blocks;
  Ray<T> ray;
};

/// The nearest hit of all, infinity where nothing is hit; but for those in doubt.
template <class T>
struct LeastHit {
  T t;
  bool is_in_doubt;
};

/// One method's kernel for many shapes. Both functions write each shape's nearest hit, infinity for a miss.
/// It is NaN where that is in doubt: where a quick phase is, or where a root at infinity may count as a hit.
template <class Method, class Problem>
struct ObjectKernel {
  using T = typename Many<Problem>::Number;
  LeastHit<T> (*meet)(const Many<Problem>& in, T* t) = nullptr;
  LeastHit<T> (*meet_in_world)(const Many<Problem>& in, T* t) = nullptr;  ///< of shapes under a matrix
};

/// Keeps the nearest hits of rays and the indices of whose they are, while one object after the other is met.
template <class T>
struct KeepNearerKernel {
  /// `t`: of the object with this index, infinity for a miss. Of two at one t the lower index is kept.
  void (*keep)(const T* t, std::uint32_t index, std::size_t size, T* nearest, std::uint32_t* whose) = nullptr;
};

/// The methods that an object list asks by kernels, and the table of these.
template <class Topic>
auto kernels_of_topic() {
  if constexpr (has_columns<Topic>) {
    using Floats = typename Topic::template Problem<float>;
    using Doubles = typename Topic::template Problem<double>;
    using Plain = typename Topic::Plain;
    using Exact = typename Topic::Exact;
    return std::tuple<ObjectKernel<Plain, Floats>, ObjectKernel<Plain, Doubles>, ObjectKernel<Exact, Floats>,
                      ObjectKernel<Exact, Doubles>>{};
  } else {
    return std::tuple<>{};
  }
}
template <class... All>
auto kernels_of_topics(TypeList<All...>) {
  return std::tuple_cat(std::tuple<KeepNearerKernel<float>, KeepNearerKernel<double>>{},
                        kernels_of_topic<All>()...);
}
using KernelTable = decltype(kernels_of_topics(Topics{}));

/// Whether a method meets many of these shapes by a kernel, and whether also under matrices: a method that
/// takes the matrix itself computes with more than a pack holds.
template <class Method, class Problem>
inline constexpr bool has_kernel = batch::is_in<ObjectKernel<Method, Problem>, KernelTable>;
template <class Method, template <class> class Shape, class T>
inline constexpr bool has_kernel_in_world =
    has_kernel<Method, RayProblem<Shape, T>> && !takes_transforms<Method, T, Shape<T>>;

/// The table that was compiled for an instruction set.
template <InstructionSet set>
const KernelTable& built_table();

/// The table built for an instruction set that is available.
[[nodiscard]] const KernelTable& kernel_table(InstructionSet set);

}  // namespace rayproof::objects
