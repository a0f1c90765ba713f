/// \file
/// The kernels for one ray and many objects of a shape. Compiled once for each instruction set, with
/// RAYPROOF_INSTRUCTION_SET naming the one it is for.

#include <array>
#include <bit>
#include <rayproof/objects/kernels.hpp>
#include <utility>

#include "columns.hpp"

namespace rayproof::objects {

namespace {

/// A number of the shapes of a block, read a pack at a time: `Sphere<Column<float>>` is as many spheres as a
/// pack has lanes.
template <class T>
struct Column {
  const T* from;
  template <class N>
  requires requires { N::size; }
  explicit operator N() const { return batch::LaneAccess<N>::load(from); }
};

/// What has these columns of a block for its numbers.
template <class Columned, class T, std::size_t... numbers>
Columned columned(const T* block, std::index_sequence<numbers...> /*of it*/) {
  return std::bit_cast<Columned>(std::array{Column<T>{block + numbers * lanes}...});
}

/// The methods `rounded` by their quick phase, the others as they are: the nearest hit, and where it is sure.
template <class Method, template <class> class Shape, class T, class N>
auto meet_shape(const Ray<N>& ray, const Shape<N>& shape) {
  if constexpr (has_quick_phase<Method>) {
    using Wide = WiderThan<T, N>;
    return rounded_nearest(ray, Method::enclosed(convert<Wide>(ray), prepared<Method>(convert<Wide>(shape))));
  } else {
    const auto roots = Method::roots(ray, shape);
    const N t = nearest(ray, roots);
    return Quick<N, N>{t, !(any(ray, roots) && t == N(infinity<N>))};
  }
}

/// In packs, flat, since a pack that is handed to a function out of line goes through memory.
template <class Method, bool is_in_world, template <class> class Shape, class T>
RAYPROOF_FLAT LeastHit<T> meet_all(const Many<RayProblem<Shape, T>>& given, T* out) {
  using All = Many<RayProblem<Shape, T>>;
  constexpr std::size_t space_numbers = is_in_world ? All::space_numbers : 0;
  const All in = given;  // its own copy: nothing that is written can change it
  using N = std::conditional_t<has_quick_phase<Method>, Pack<double>, Pack<T>>;
  static_assert(lanes % N::size == 0);
  N least(infinity<T>);
  Mask<N> is_sure(true);
  for (std::size_t i = 0; i < in.blocks * lanes; i += N::size) {
    const T* const block = in.numbers + i / lanes * lanes * (All::shape_numbers + space_numbers) + i % lanes;
    const auto shape =
        convert<N>(columned<Shape<Column<T>>>(block, std::make_index_sequence<All::shape_numbers>()));
    Ray<N> ray = convert<N>(in.ray);
    if constexpr (is_in_world) {
      const auto space = columned<ObjectSpace<Column<T>>>(block + All::shape_numbers * lanes,
                                                          std::make_index_sequence<space_numbers>());
      ray = to_object(convert<N>(space), ray);
    }
    const auto [t, is_sure_now] = meet_shape<Method, Shape, T>(ray, shape);
    is_sure = is_sure && is_sure_now;
    const N answer = select(is_sure_now, t, N(not_a_number<N>));
    least = min(least, answer);
    batch::LaneAccess<N>::store(answer, out + i);
  }
  return {static_cast<T>(std::experimental::hmin(least.lanes())), !std::experimental::all_of(is_sure)};
}

template <class T>
void keep_nearer(const T* t, std::uint32_t index, std::size_t size, T* nearest, std::uint32_t* whose) {
  for (std::size_t i = 0; i < size; ++i) {
    const bool is_first_of_two = t[i] == nearest[i] && t[i] < infinity<T> && index < whose[i];
    const bool is_nearer = t[i] < nearest[i] || is_first_of_two;
    nearest[i] = is_nearer ? t[i] : nearest[i];
    whose[i] = is_nearer ? index : whose[i];
  }
}

template <class T>
constexpr void enter(KeepNearerKernel<T>& kernel) {
  kernel.keep = keep_nearer<T>;
}
template <class Method, template <class> class Shape, class T>
constexpr void enter(ObjectKernel<Method, RayProblem<Shape, T>>& kernel) {
  kernel.meet = meet_all<Method, false, Shape, T>;
  if constexpr (has_kernel_in_world<Method, Shape, T>)
    kernel.meet_in_world = meet_all<Method, true, Shape, T>;
}

constexpr KernelTable built = batch::filled<KernelTable>([](auto& kernel) { enter(kernel); });

}  // namespace

template <>
const KernelTable& built_table<InstructionSet::RAYPROOF_INSTRUCTION_SET>() {
  return built;
}

}  // namespace rayproof::objects
