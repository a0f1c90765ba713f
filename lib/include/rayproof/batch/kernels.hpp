#pragma once
/// \file
/// The compiled batch kernels as tables of functions, one table for each instruction set; batch.hpp calls
/// them.
///
/// What a kernel is handed holds bare pointers: its object code is for one instruction set, and must contain
/// no inline function that the linker could put in the place of another instruction set's.

#include <array>
#include <concepts>
#include <cstddef>
#include <rayproof/arithmetics/bounded.hpp>
#include <rayproof/batch/instruction_set.hpp>
#include <rayproof/nearest_hit.hpp>
#include <rayproof/topics.hpp>
#include <rayproof/transform.hpp>
#include <tuple>
#include <type_traits>

namespace rayproof::batch {

/// The input of a batch of problems: one column for each number that differs from problem to problem.
template <class Problem>
struct Lanes;

/// The columns a, b, c. Results: the discriminant and both roots.
template <class T>
struct Lanes<Quadratic<T>> {
  using Number = T;
  using Topic = quadratic::Topic;
  static constexpr std::size_t results = 3;
  const T* columns[3];
  std::size_t size;
};

/// The columns of origin and direction, of t_min and t_max where they differ from ray to ray (null where they
/// do not), and what the rays have in common. Results: the nearest hit (infinity for a miss), u, v (of
/// shapes that are not flat the lower root, which says nothing), the discriminant and both roots.
template <template <class> class Shape, class T>
struct Lanes<RayProblem<Shape, T>> {
  using Number = T;
  using Topic = RayTopic<Shape>;
  static constexpr std::size_t results = 6;
  const T* columns[8];
  std::size_t size;
  std::array<T, 2> interval;  ///< t_min and t_max of all rays that have no column of them
  Shape<T> shape;
};

/// Puts what one problem, or a pack of them, came to in its order.
template <class Lanes, class Problem, class Roots, class N>
constexpr void put_results(const Problem& problem, const Roots& roots, N (&to)[Lanes::results]) {
  if constexpr (requires { problem.ray; }) {
    to[0] = nearest(problem.ray, roots);
    to[1] = to[2] = roots.lo;
    if constexpr (requires { roots.u; }) {
      to[1] = roots.u;
      to[2] = roots.v;
    }
  }
  to[Lanes::results - 3] = roots.discriminant;
  to[Lanes::results - 2] = roots.lo;
  to[Lanes::results - 1] = roots.hi;
}

/// Whether a method runs in packs, or is for plain numbers alone: then the constraint of its `roots` says so.
struct AnyNumber {};
template <class Method>
inline constexpr bool runs_in_packs = requires {
  &Method::template roots<AnyNumber>;
};
/// Whether there is a quick phase of rays that are in the world. In packs it runs for rays in float alone:
/// with the digits that doubles take, these kernels would nearly double the time to compile.
template <class Method>
inline constexpr bool has_quick_phase_in_world = requires {
  &Method::template enclosed_in_space<AnyNumber>;
};
template <class Method, class T>
inline constexpr bool has_kernel_in_world = has_quick_phase_in_world<Method>&& std::same_as<T, float>;
/// Whether a method has kernels. What is wrong as printed has none: nobody wants it fast.
template <class Method>
inline constexpr bool has_kernels = (runs_in_packs<Method> || has_quick_phase<Method>)&&  //
                                    Method::contract.standing
                                    != Standing::printed;

/// No more problems are given to a kernel with a quick phase at once.
inline constexpr std::size_t quick_block = 512;

/// One method's kernel in one precision.
template <class Method, class Problem>
struct BatchKernel {
  using T = typename Lanes<Problem>::Number;
  /// Writes every problem's results: all of them, or the first alone. They are written in their order, so
  /// that a column nobody wants may share the memory of a later one. Returns whether a quick phase was in
  /// doubt somewhere: there all results are NaN.
  bool (*solve)(const Lanes<Problem>& in, T* const (&out)[Lanes<Problem>::results], bool all) = nullptr;
  /// The same by a quick phase of rays in the world, where the method has one.
  bool (*solve_in_world)(const Lanes<Problem>& in, const ObjectSpace<Bounded<double>>& space,
                         T* const (&out)[Lanes<Problem>::results], bool all) = nullptr;
};

/// Takes rays, as columns of origin and direction, into an object's space.
template <class T>
struct ToObjectKernel {
  void (*move)(const T* const (&in)[6], std::size_t size, const ObjectSpace<T>& space,
               T* const (&out)[6]) = nullptr;
};

template <class Topic, class... Methods>
auto kernels_of_topic(TypeList<Methods...>) {
  [[maybe_unused]] const auto of = []<class Method>(std::type_identity<Method>) {
    using Floats = BatchKernel<Method, typename Topic::template Problem<float>>;
    using Doubles = BatchKernel<Method, typename Topic::template Problem<double>>;
    if constexpr (has_kernels<Method>) {
      return std::tuple<Floats, Doubles>{};
    } else {
      return std::tuple<>{};
    }
  };
  return std::tuple_cat(of(std::type_identity<Methods>{})...);
}
template <class... All>
auto kernels_of_topics(TypeList<All...>) {
  return std::tuple_cat(
      std::tuple<ToObjectKernel<float>, ToObjectKernel<double>>{},
      kernels_of_topic<All>(std::conditional_t<is_batched<All>, typename All::Methods, TypeList<>>{})...);
}
/// Every method of every batched topic in both precisions.
using KernelTable = decltype(kernels_of_topics(Topics{}));

/// Whether a type is in a list: a TypeList, or a tuple.
template <class Type, class List>
inline constexpr bool is_in = false;
template <class Type, template <class...> class List, class... Types>
inline constexpr bool is_in<Type, List<Types...>> = (std::same_as<Type, Types> || ...);

/// Whether a batch of these problems can be given to the method: it is one of a batched topic's.
template <class Method, class Problem, class... All>
constexpr bool answers_in(TypeList<All...>) {
  const auto is_of = []<class Topic>(std::type_identity<Topic>) {
    if constexpr (is_batched<Topic>) {
      using T = typename Lanes<Problem>::Number;
      return (std::same_as<T, float> || std::same_as<T, double>)&&  //
             std::same_as<typename Topic::template Problem<T>, Problem> &&
             is_in<Method, typename Topic::Methods>;
    }
    return false;
  };
  return (is_of(std::type_identity<All>{}) || ...);
}
template <class Method, class Problem>
inline constexpr bool answers_batches = answers_in<Method, Problem>(Topics{});

/// The table that was compiled for an instruction set.
template <InstructionSet set>
const KernelTable& built_table();

/// The table built for an instruction set that is available.
[[nodiscard]] const KernelTable& kernel_table(InstructionSet set);

}  // namespace rayproof::batch
