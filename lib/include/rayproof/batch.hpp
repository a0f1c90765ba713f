#pragma once
/// \file
/// Many rays against one shape, or many equations, at once: bit for bit the answers of the scalar kernels.
///
/// \code
/// const std::vector<float> x{0, 0.5F, 2}, y(3), z(3, -5), dx(3), dy(3), dz(3, 1);
/// const rayproof::RayBatch<float> rays{{x, y, z}, {dx, dy, dz}};
/// std::vector<float> t(3);
/// rayproof::nearest_hits<rayproof::sphere::Centred>(rays, rayproof::Sphere<float>{{0, 0, 0}, 1}, t);
/// assert(t[0] == 4 && t[2] == rayproof::infinity<float>);
/// \endcode
///
/// The kernels are built for several instruction sets, and the widest one this machine has is chosen at run
/// time. The methods of the topics marked `is_batched` have them, in float and in double; a method that is
/// for plain numbers alone, or wrong as printed, and every method of the other shapes, runs ray by ray.

#include <optional>
#include <rayproof/batch/instruction_set.hpp>
#include <rayproof/batch/solve.hpp>
#include <span>
#include <stdexcept>
#include <type_traits>

namespace rayproof {

/// One array for each coordinate.
template <class T>
struct Coordinates {
  std::span<const T> x, y, z;
};

/// Rays as six arrays of one length, with a common interval of t, either end of which gives way to an array
/// of one for each ray. Where `object_space` is given the rays are in the world, and meet the shape in that
/// space; t is the same in both.
template <class T>
struct RayBatch {
  Coordinates<T> origin;
  Coordinates<T> direction;
  T t_min = T(0);
  T t_max = infinity<T>;
  std::optional<ObjectSpace<T>> object_space{};
  std::span<const T> each_t_min{}, each_t_max{};  ///< empty where the common one counts
};

/// Quadratic equations as three arrays of one length.
template <class T>
struct QuadraticBatch {
  std::span<const T> a, b, c;
};

/// Where a batch's roots go, with the meaning of Roots; three arrays as long as the batch. For flat shapes
/// (plane, triangle) u and v may be given too, with the meaning of FlatHit.
template <class T>
struct RootArrays {
  std::span<T> discriminant, lo, hi;
  std::span<T> u{}, v{};
};

namespace batch {

/// Throws std::invalid_argument unless all arrays are as long as the first; returns that length.
template <class First, class... Rest>
std::size_t common_size(const First& first, const Rest&... rest) {
  if (((rest.size() != first.size()) || ...))
    throw std::invalid_argument("the arrays of a batch differ in length");
  return first.size();
}

/// Where an array begins that may be left out, or `otherwise`.
template <class T, class First>
[[nodiscard]] T* begin_of(std::span<T> column, const First& first, std::type_identity_t<T*> otherwise) {
  if (column.empty()) return otherwise;
  common_size(first, column);
  return column.data();
}

/// The columns of a batch of rays, valid as long as `rays`.
template <class T, template <class> class Shape>
[[nodiscard]] Lanes<RayProblem<Shape, T>> lanes_of(const RayBatch<T>& rays, const Shape<T>& shape) {
  const auto& [origin, direction, t_min, t_max, space, each_t_min, each_t_max] = rays;
  const std::size_t size = common_size(origin.x, origin.y, origin.z, direction.x, direction.y, direction.z);
  return {
      {origin.x.data(), origin.y.data(), origin.z.data(), direction.x.data(), direction.y.data(),
       direction.z.data(), begin_of(each_t_min, origin.x, nullptr), begin_of(each_t_max, origin.x, nullptr)},
      size,
      {t_min, t_max},
      shape};
}

}  // namespace batch

/// The nearest hit of each ray: the smallest root in [t_min, t_max], or infinity for a miss. `t` is as long
/// as the batch. `set` is one of available_instruction_sets(); one that is not built is refused by a
/// std::invalid_argument.
template <class Method, class T, template <class> class Shape>
void nearest_hits(const RayBatch<T>& rays, const Shape<T>& shape, std::type_identity_t<std::span<T>> t,
                  InstructionSet set = preferred_instruction_set()) {
  batch::common_size(rays.origin.x, t);
  T* const out[6] = {t.data()};
  batch::solve<Method>(set, batch::lanes_of(rays, shape), out, false, rays.object_space);
}

/// Both roots of each ray's problem, before the interval of t is looked at.
template <class Method, class T, template <class> class Shape>
void batch_roots(const RayBatch<T>& rays, const Shape<T>& shape, const RootArrays<T>& roots,
                 InstructionSet set = preferred_instruction_set()) {
  batch::common_size(rays.origin.x, roots.discriminant, roots.lo, roots.hi);
  // What nobody wants is written where a root is written after it.
  T* const spare = roots.lo.data();
  const auto given = [&](std::span<T> column) { return batch::begin_of(column, rays.origin.x, spare); };
  batch::solve<Method>(
      set, batch::lanes_of(rays, shape),
      {spare, given(roots.u), given(roots.v), roots.discriminant.data(), spare, roots.hi.data()}, true,
      rays.object_space);
}

/// Both roots of each equation.
template <class Method, class T>
void batch_roots(const QuadraticBatch<T>& equations, const RootArrays<T>& roots,
                 InstructionSet set = preferred_instruction_set()) {
  const auto& [a, b, c] = equations;
  const std::size_t size = batch::common_size(a, b, c, roots.discriminant, roots.lo, roots.hi);
  batch::solve<Method>(set, batch::Lanes<Quadratic<T>>{{a.data(), b.data(), c.data()}, size},
                       {roots.discriminant.data(), roots.lo.data(), roots.hi.data()}, true);
}

}  // namespace rayproof
