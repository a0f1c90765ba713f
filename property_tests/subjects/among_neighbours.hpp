#pragma once
/// \file
/// One problem answered by the batch kernels, among other problems: for tests that a batch equals the scalar
/// kernels.

#include <array>
#include <bit>
#include <cstdint>
#include <rayproof/batch.hpp>
#include <type_traits>

namespace rayproof::batch {

/// More lanes than two of the widest packs have, so that every lane of a pack and of the padded tail is in
/// reach. A method that runs one number at a time has no lanes to mix up.
template <class Method>
inline constexpr std::size_t mixed_lanes = has_kernels<Method> ? 37 : 1;

/// Columns with one problem's numbers at a lane that depends on their bits, and hard numbers in all other
/// lanes.
template <class T, std::size_t Columns, std::size_t Lanes>
struct MixedLanes {
  std::array<std::array<T, Lanes>, Columns> column;
  std::size_t lane = 0;

  explicit MixedLanes(const std::array<T, Columns>& problem) {
    using Limits = std::numeric_limits<T>;
    constexpr std::array<T, 9> hard{
        T(1),          T(0),    -Limits::infinity(), Limits::quiet_NaN(), T(-2), Limits::min(),
        Limits::max(), T(-0.0), Limits::denorm_min()};
    using Bits = std::conditional_t<sizeof(T) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t>;
    std::uint64_t hash = 0;
    for (std::size_t c = 0; c < Columns; ++c) {
      for (std::size_t i = 0; i < Lanes; ++i) column[c][i] = hard[(c * c + i) % hard.size()];
      hash = (hash ^ std::bit_cast<Bits>(problem[c])) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 32U;
    }
    lane = hash % Lanes;
    for (std::size_t c = 0; c < Columns; ++c) column[c][lane] = problem[c];
  }
};

/// Arrays of roots, and what the method answered in one lane, of the type that its `roots` returns.
template <class T, class Result, std::size_t Lanes>
struct MixedRoots {
  std::array<T, Lanes> discriminant{}, lo{}, hi{}, u{}, v{};
  [[nodiscard]] RootArrays<T> arrays() { return {discriminant, lo, hi, u, v}; }
  [[nodiscard]] Result at(std::size_t lane) const {
    const Roots<T> roots{discriminant[lane], lo[lane], hi[lane]};
    if constexpr (requires(Result result) { result.u; }) {
      return {roots, u[lane], v[lane]};
    } else {
      return roots;
    }
  }
};

/// One ray among others. It is in the world where `space` is given. In every other lane it has the ends of
/// its interval in columns, in the rest in common with all.
template <class Method, class T>
struct MixedRays {
  MixedLanes<T, 8, mixed_lanes<Method>> lanes;
  RayBatch<T> batch;

  MixedRays(const Ray<T>& ray, const std::optional<ObjectSpace<T>>& space)
      : lanes({ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z,
               ray.t_min, ray.t_max}) {
    const auto& c = lanes.column;
    batch = {{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, ray.t_min, ray.t_max, space};
    if (lanes.lane % 2 == 1) {
      batch = {batch.origin, batch.direction, not_a_number<T>, not_a_number<T>, space, c[6], c[7]};
    }
  }
  MixedRays(const MixedRays&) = delete;  // the batch looks at the lanes
  MixedRays& operator=(const MixedRays&) = delete;
};

/// The roots of one ray's problem, answered in a batch of many.
template <class Method, class T, class Shape>
[[nodiscard]] auto roots_among_neighbours(const Ray<T>& ray, const Shape& shape,
                                          const std::optional<ObjectSpace<T>>& space = {},
                                          InstructionSet set = preferred_instruction_set()) {
  const MixedRays<Method, T> rays(ray, space);
  MixedRoots<T, decltype(Method::roots(ray, shape)), mixed_lanes<Method>> roots;
  batch_roots<Method>(rays.batch, shape, roots.arrays(), set);
  return roots.at(rays.lanes.lane);
}

/// The nearest hit alone of one ray, answered in a batch of many.
template <class Method, class T, class Shape>
[[nodiscard]] T nearest_among_neighbours(const Ray<T>& ray, const Shape& shape,
                                         InstructionSet set = preferred_instruction_set()) {
  const MixedRays<Method, T> rays(ray, {});
  std::array<T, mixed_lanes<Method>> t{};
  nearest_hits<Method>(rays.batch, shape, std::span<T>(t), set);
  return t[rays.lanes.lane];
}

/// The roots of one equation, answered in a batch of many.
template <class Method, class T>
[[nodiscard]] Roots<T> roots_among_neighbours(const Quadratic<T>& q,
                                              InstructionSet set = preferred_instruction_set()) {
  const MixedLanes<T, 3, mixed_lanes<Method>> lanes({q.a, q.b, q.c});
  MixedRoots<T, Roots<T>, mixed_lanes<Method>> roots;
  batch_roots<Method>(QuadraticBatch<T>{lanes.column[0], lanes.column[1], lanes.column[2]}, roots.arrays(),
                      set);
  return roots.at(lanes.lane);
}

}  // namespace rayproof::batch
