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

/// A ray topic's input: origin and direction in six columns.
template <class T, class Shape>
struct RayLanes {
  const T* columns[6];
  std::size_t size;
  T t_min, t_max;
  Shape shape;
  const ObjectSpace<T>* object_space;  ///< null where the rays are in the shape's own space already
};

/// The quadratic's input: a, b, c.
template <class T>
struct QuadraticLanes {
  const T* columns[3];
  std::size_t size;
};

template <class Problem>
concept RayProblem = requires(Problem problem) {
  problem.ray;
  problem.shape;
};

template <class T, class Problem>
struct LanesOf {
  using type = QuadraticLanes<T>;
};
template <class T, RayProblem Problem>
struct LanesOf<T, Problem> {
  using type = RayLanes<T, decltype(Problem::shape)>;
};
/// The input of a batch of a topic's problems.
template <class Topic, class T>
using Lanes = typename LanesOf<T, typename Topic::template Problem<T>>::type;

/// Whether a method runs in packs, or is for plain numbers alone: then the constraint of its `roots` says so.
struct AnyNumber {};
template <class Method>
inline constexpr bool runs_in_packs = requires {
  &Method::template roots<AnyNumber>;
};

/// One method's kernels in one precision. Null where it has none: the baseline's is used then.
template <class Topic, class Method, class T>
struct Kernels {
  /// Writes the discriminant and both roots of every problem.
  void (*roots)(const Lanes<Topic, T>& in, T* const (&out)[3]) = nullptr;
  /// Writes the nearest hit of every ray, infinity for a miss; null for topics without a ray.
  void (*nearest)(const Lanes<Topic, T>& in, T* const (&out)[1]) = nullptr;
};

template <class Topic, class... Methods>
auto kernels_of_topic(TypeList<Methods...>) -> decltype(std::tuple_cat(
    std::tuple<>{}, std::tuple<Kernels<Topic, Methods, float>, Kernels<Topic, Methods, double>>{}...));
template <class... All>
auto kernels_of_topics(TypeList<All...>) -> decltype(std::tuple_cat(
    kernels_of_topic<All>(std::conditional_t<is_batched<All>, typename All::Methods, TypeList<>>{})...));
/// Every method of every batched topic in both precisions.
using KernelTable = decltype(kernels_of_topics(Topics{}));

/// The table built for an instruction set that is available.
[[nodiscard]] const KernelTable& kernel_table(InstructionSet set);

/// The topic that a method belongs to; void for a method of no topic.
template <class Method>
std::type_identity<void> topic_of(TypeList<>);
template <class Method, class First, class... Rest>
auto topic_of(TypeList<First, Rest...>) {
  constexpr bool is_listed = []<class... Methods>(TypeList<Methods...>) {
    return (std::same_as<Methods, Method> || ...);
  }(typename First::Methods{});
  if constexpr (is_listed) {
    return std::type_identity<First>{};
  } else {
    return batch::topic_of<Method>(TypeList<Rest...>{});
  }
}
template <class Method>
using TopicOf = typename decltype(batch::topic_of<Method>(Topics{}))::type;

/// The kernels of a method in one precision, as the tables hold them.
template <class Method, class T>
using KernelsOf = Kernels<TopicOf<Method>, Method, T>;

template <class Entry, class Table>
inline constexpr bool is_in = false;
template <class Entry, class... Entries>
inline constexpr bool is_in<Entry, std::tuple<Entries...>> = (std::same_as<Entry, Entries> || ...);

/// Whether a method has kernels for problems that are laid out as `In`.
template <class Method, class T, class In>
inline constexpr bool has_kernels = requires {
  requires is_in<KernelsOf<Method, T>, KernelTable>;
  requires std::same_as<Lanes<TopicOf<Method>, T>, In>;
};

}  // namespace rayproof::batch
