#pragma once
/// \file
/// The compiled batch kernels as tables of functions, one table for each instruction set; batch.hpp calls
/// them.
///
/// What a kernel is handed holds bare pointers: its object code is for one instruction set, and must contain
/// no inline function that the linker could put in the place of another instruction set's.

#include <concepts>
#include <cstddef>
#include <rayproof/batch/instruction_set.hpp>
#include <rayproof/topics.hpp>
#include <rayproof/transform.hpp>
#include <tuple>
#include <type_traits>

namespace rayproof::batch {

/// The input of a batch of problems: one column for each number that differs from problem to problem.
template <class Problem>
struct Lanes;

/// The columns a, b, c.
template <class T>
struct Lanes<Quadratic<T>> {
  using Number = T;
  using Topic = quadratic::Topic;
  const T* columns[3];
  std::size_t size;
};

/// The columns of origin and direction, and what the rays have in common.
template <template <class> class Shape, class T>
struct Lanes<RayProblem<Shape, T>> {
  using Number = T;
  using Topic = RayTopic<Shape>;
  const T* columns[6];
  std::size_t size;
  T t_min, t_max;
  Shape<T> shape;
  bool is_moved;                ///< the rays are in the world, and meet the shape in its own space
  ObjectSpace<T> object_space;  ///< that space
};

/// Whether a method runs in packs, or is for plain numbers alone: then the constraint of its `roots` says so.
struct AnyNumber {};
template <class Method>
inline constexpr bool runs_in_packs = requires {
  &Method::template roots<AnyNumber>;
};

/// One method's kernels in one precision. Null where it has none: the baseline's is used then.
template <class Method, class Problem>
struct Kernels {
  using T = typename Lanes<Problem>::Number;
  /// Writes the discriminant and both roots of every problem.
  void (*roots)(const Lanes<Problem>& in, T* const (&out)[3]) = nullptr;
  /// Writes the nearest hit of every ray, infinity for a miss; null for topics without a ray.
  void (*nearest)(const Lanes<Problem>& in, T* const (&out)[1]) = nullptr;
};

template <class Topic, class... Methods>
auto kernels_of_topic(TypeList<Methods...>)
    -> decltype(std::tuple_cat(std::tuple<Kernels<Methods, typename Topic::template Problem<float>>,
                                          Kernels<Methods, typename Topic::template Problem<double>>>{}...));
template <class... All>
auto kernels_of_topics(TypeList<All...>) -> decltype(std::tuple_cat(
    kernels_of_topic<All>(std::conditional_t<is_batched<All>, typename All::Methods, TypeList<>>{})...));
/// Every method of every batched topic in both precisions.
using KernelTable = decltype(kernels_of_topics(Topics{}));

template <class Entry, class Table>
inline constexpr bool is_in = false;
template <class Entry, class... Entries>
inline constexpr bool is_in<Entry, std::tuple<Entries...>> = (std::same_as<Entry, Entries> || ...);

/// The table that was compiled for an instruction set.
template <InstructionSet set>
const KernelTable& built_table();

/// The table built for an instruction set that is available.
[[nodiscard]] const KernelTable& kernel_table(InstructionSet set);

}  // namespace rayproof::batch
