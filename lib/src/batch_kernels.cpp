/// \file
/// The batch kernels: columns are read a pack at a time, made into problems, solved and written. Compiled
/// once for each instruction set, with RAYPROOF_INSTRUCTION_SET naming the one it is for.

#include <rayproof/batch/kernels.hpp>

#include "columns.hpp"
#include "correction.hpp"

namespace rayproof::batch {

namespace {

/// One equation a lane.
template <class N, class T>
Quadratic<N> problem_of(const Lanes<Quadratic<T>>& /*in*/, const N (&column)[3]) {
  return {column[0], column[1], column[2]};
}

/// The same with the common shape. It is kept as plain numbers: g++ 12 copies packs inside structs in halves,
/// which stalls; spreading a number anew costs nothing.
template <class N, template <class> class Shape, class T>
RayProblem<Shape, N> problem_of(const Lanes<RayProblem<Shape, T>>& in, const N (&column)[8]) {
  return {ray_of<N>(column), convert<N>(in.shape)};
}

/// What the problems have in common that may have columns, too.
template <class T>
std::array<T, 0> interval_of(const Lanes<Quadratic<T>>& /*in*/) {
  return {};
}
template <template <class> class Shape, class T>
std::array<T, 2> interval_of(const Lanes<RayProblem<Shape, T>>& in) {
  return in.interval;
}

/// Solves the problems in packs; flat, since a pack that is handed to a function out of line goes through
/// memory.
template <class Method, class Problem, class T, std::size_t Columns>
RAYPROOF_FLAT bool solve(const Lanes<Problem>& given, T* const (&out)[Columns], bool all) {
  const Lanes<Problem> in = given;  // its own copy: nothing that is written can change it
  using N = Pack<T>;
  const auto fill = [&](const auto& columns, N(&to)[Columns]) {
    auto problem = problem_of<N>(in, columns);
    put_results<Lanes<Problem>>(problem, Lanes<Problem>::Topic::template solve<Method>(problem), to);
  };
  run<N>(in.columns, out, in.size, fill, all ? Columns : 1, interval_of(in));
  return false;
}

/// Rays that are in the shape's own space.
struct OwnSpace {};

/// What a method's quick phase knows of a ray: in packs of doubles or of double-doubles, or in the world in
/// packs of doubles with bounds on their errors.
template <class Method, class T, class N, class Shape>
auto enclosed(const OwnSpace& /*space*/, const Ray<N>& ray, const Shape& shape) {
  using Wide = WiderThan<T, N>;
  return Method::enclosed(convert<Wide>(ray), convert<Wide>(shape));
}
template <class Method, class T, class N, class Shape>
auto enclosed(const ObjectSpace<Bounded<double>>& space, const Ray<N>& ray, const Shape& shape) {
  using B = Bounded<N>;
  return Method::enclosed_in_space(to_object(convert<B>(space), convert<B>(ray)), convert<B>(shape));
}

/// The same by a method's quick phase, all hits or the nearest alone. What it is not sure of is NaN. Returns
/// whether there is any. Nothing made of packs is const: g++ 12 leaves const structs in memory, and computes
/// what nobody asks for, such as a plane's u and v for the nearest hit.
template <class Method, class Problem, class Space, class T, class All, std::size_t Columns>
RAYPROOF_FLAT bool solve_quickly(const Lanes<Problem>& given, const Space& given_space,
                                 T* const (&out)[Columns], All all) {
  const Lanes<Problem> in = given;
  const Space space = given_space;
  const auto shape = [&] {
    auto wide = convert<WiderThan<T>>(in.shape);
    if constexpr (std::same_as<Space, OwnSpace>) {
      return prepared<Method>(wide);
    } else {
      return wide;
    }
  }();
  using N = Pack<double>;
  Mask<N> is_sure(true);
  const auto fill = [&](const N(&columns)[8], N(&to)[Columns]) {
    Ray<N> ray = ray_of<N>(columns);
    auto known = enclosed<Method, T>(space, ray, shape);
    const auto keep = [&](const Mask<N>& is_sure_now, std::size_t wanted) {
      is_sure = is_sure && is_sure_now;
      for (std::size_t i = 0; i < wanted; ++i) to[i] = select(is_sure_now, to[i], N(not_a_number<N>));
    };
    if (all) {
      auto quick = rounded_roots(ray, known);
      const struct { const Ray<N>& ray; } problem{ray};
      put_results<Lanes<Problem>>(problem, quick.answer, to);
      keep(quick.is_sure, Columns);
    } else {
      auto quick = rounded_nearest(ray, known);
      to[0] = quick.answer;
      keep(quick.is_sure, 1);
    }
  };
  run<N>(in.columns, out, in.size, fill, all ? Columns : 1, interval_of(in));
  return !std::experimental::all_of(is_sure);
}
/// A loop for each: the nearest hit needs less of the phase, and none of it where it is found by correction.
template <class Method, class Problem, class T, std::size_t Columns>
bool solve_in_own_space(const Lanes<Problem>& in, T* const (&out)[Columns], bool all) {
  if (all) return solve_quickly<Method>(in, OwnSpace(), out, std::true_type());
  if constexpr (has_correction<Method>) {
    if (correct<Method>(in, out[0])) return false;
    if (!are_many_unsure(out[0], in.size)) return true;
  }
  return solve_quickly<Method>(in, OwnSpace(), out, std::false_type());
}
/// One loop for both, which compiles in half the time: hardly any of this phase could be left out.
template <class Method, class Problem, class T, std::size_t Columns>
bool solve_in_world(const Lanes<Problem>& in, const ObjectSpace<Bounded<double>>& space,
                    T* const (&out)[Columns], bool all) {
  return solve_quickly<Method>(in, space, out, all);
}

template <class T>
RAYPROOF_FLAT void move(const T* const (&in)[6], std::size_t size, const ObjectSpace<T>& given,
                        T* const (&out)[6]) {
  const ObjectSpace<T> space = given;
  using N = Pack<T>;
  run<N>(in, out, size, [&](const N(&c)[6], N(&to)[6]) {
    Ray<N> ray = to_object(convert<N>(space), Ray<N>{{c[0], c[1], c[2]}, {c[3], c[4], c[5]}});
    const auto& [o, d, t_min, t_max] = ray;
    const N numbers[6] = {o.x, o.y, o.z, d.x, d.y, d.z};
    for (std::size_t i = 0; i < 6; ++i) to[i] = numbers[i];
  });
}

template <class Method, class Problem>
constexpr void enter(BatchKernel<Method, Problem>& kernel) {
  if constexpr (has_quick_phase<Method>) {
    using T = typename Lanes<Problem>::Number;
    kernel.solve = solve_in_own_space<Method, Problem, T>;
    if constexpr (has_kernel_in_world<Method, T>) {
      kernel.solve_in_world = solve_in_world<Method, Problem, T>;
    }
  } else {
    kernel.solve = solve<Method, Problem>;
  }
}
template <class T>
constexpr void enter(ToObjectKernel<T>& kernel) {
  kernel.move = move<T>;
}

constexpr KernelTable built = filled<KernelTable>([](auto& kernel) { enter(kernel); });

}  // namespace

template <>
const KernelTable& built_table<InstructionSet::RAYPROOF_INSTRUCTION_SET>() {
  return built;
}

}  // namespace rayproof::batch
