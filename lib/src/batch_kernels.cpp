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

/// One ray a lane.
template <class N>
Ray<N> ray_of(const N (&column)[8]) {
  return {{column[0], column[1], column[2]}, {column[3], column[4], column[5]}, column[6], column[7]};
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
    const auto problem = problem_of<N>(in, columns);
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
  return Method::enclosed(convert<Wide>(ray), convert<Wide>(convert<N>(shape)));
}
template <class Method, class T, class N, class Shape>
auto enclosed(const ObjectSpace<Bounded<double>>& space, const Ray<N>& ray, const Shape& shape) {
  using B = Bounded<N>;
  return Method::enclosed_in_space(to_object(convert<B>(space), convert<B>(ray)),
                                   convert<B>(convert<N>(shape)));
}

/// The same by a method's quick phase: `solve(ray, enclosed, to)` says where it is sure. What is not is NaN.
/// Returns whether there is any.
template <class Method, class Problem, class T, class Space, std::size_t Columns, class Solve>
bool solve_quickly(const Lanes<Problem>& in, const Space& space, T* const (&out)[Columns],
                   const Solve& solve) {
  using N = Pack<double>;
  Mask<N> is_sure(true);
  const auto fill = [&](const N(&columns)[8], N(&to)[Columns]) {
    const Ray<N> ray = ray_of<N>(columns);
    const Mask<N> is_sure_now = solve(ray, enclosed<Method, T>(space, ray, in.shape), to);
    is_sure = is_sure && is_sure_now;
    for (N& result : to) result = select(is_sure_now, result, N(not_a_number<N>));
  };
  run<N>(in.columns, out, in.size, fill, Columns, interval_of(in));
  return !std::experimental::all_of(is_sure);
}

template <class Method, class Problem, class T, class Space, std::size_t Columns>
RAYPROOF_FLAT bool solve_all_quickly(const Lanes<Problem>& given, const Space& given_space,
                                     T* const (&out)[Columns]) {
  const Lanes<Problem> in = given;
  const Space space = given_space;
  return solve_quickly<Method>(in, space, out, []<class N>(const Ray<N>& ray, const auto& wide, auto& to) {
    const auto quick = rounded_roots(ray, wide);
    const struct { const Ray<N>& ray; } problem{ray};
    put_results<Lanes<Problem>>(problem, quick.answer, to);
    return quick.is_sure;
  });
}

template <class Method, class Problem, class T, class Space>
RAYPROOF_FLAT bool solve_nearest_quickly(const Lanes<Problem>& given, const Space& given_space,
                                         T* const (&out)[1]) {
  const Lanes<Problem> in = given;
  const Space space = given_space;
  return solve_quickly<Method>(in, space, out, [](const auto& ray, const auto& wide, auto& to) {
    const auto quick = rounded_nearest(ray, wide);
    to[0] = quick.answer;
    return quick.is_sure;
  });
}

/// Two functions, since g++ 12 makes less of a loop that stands in one with another.
template <class Method, class Problem, class Space, class T, std::size_t Columns>
bool solve_quickly_in(const Lanes<Problem>& in, const Space& space, T* const (&out)[Columns], bool all) {
  T* const nearest_out[1] = {out[0]};
  return all ? solve_all_quickly<Method>(in, space, out)
             : solve_nearest_quickly<Method>(in, space, nearest_out);
}
template <class Method, class Problem, class T, std::size_t Columns>
bool solve_quickly(const Lanes<Problem>& in, T* const (&out)[Columns], bool all) {
  return solve_quickly_in<Method>(in, OwnSpace(), out, all);
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
  if constexpr (has_quick_phase<Method>) {
    using T = typename Lanes<Problem>::Number;
    kernel.solve = solve_quickly<Method, Problem, T>;
    if constexpr (has_quick_phase_in_world<Method, T>) {
      kernel.solve_in_world = solve_quickly_in<Method, Problem, ObjectSpace<Bounded<double>>>;
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
