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
/// time. Methods of the topics marked `is_batched` have kernels, in float and in double.

#include <optional>
#include <rayproof/batch/instruction_set.hpp>
#include <rayproof/batch/kernels.hpp>
#include <span>
#include <stdexcept>
#include <type_traits>

namespace rayproof {

/// One array for each coordinate.
template <class T>
struct Coordinates {
  std::span<const T> x, y, z;
};

/// Rays as six arrays of one length, with a common interval of t. Where `object_space` is given the rays are
/// in the world, and meet the shape in that space; t is the same in both.
template <class T>
struct RayBatch {
  Coordinates<T> origin;
  Coordinates<T> direction;
  T t_min = T(0);
  T t_max = infinity<T>;
  std::optional<ObjectSpace<T>> object_space{};
};

/// Quadratic equations as three arrays of one length.
template <class T>
struct QuadraticBatch {
  std::span<const T> a, b, c;
};

/// Where a batch's roots go, with the meaning of Roots; three arrays as long as the batch.
template <class T>
struct RootArrays {
  std::span<T> discriminant, lo, hi;
};

namespace batch {

/// Throws std::invalid_argument unless all arrays are as long as the first; returns that length.
template <class First, class... Rest>
std::size_t common_size(const First& first, const Rest&... rest) {
  if (((rest.size() != first.size()) || ...))
    throw std::invalid_argument("the arrays of a batch differ in length");
  return first.size();
}

/// The method's kernels for `set`, or the baseline's for a method that does not run in packs.
template <class Method, class Problem>
[[nodiscard]] const auto& kernels_for(InstructionSet set) {
  using Entry = Kernels<Method, Problem>;
  const Entry& wanted = std::get<Entry>(kernel_table(set));
  return wanted.roots != nullptr ? wanted : std::get<Entry>(kernel_table(InstructionSet::baseline));
}

/// Runs the method's kernel that fills these columns: one column of nearest hits, or three of roots. A method
/// without kernels is refused here, in one sentence, before it is looked for in the tables.
template <class Method, class Problem, class T, std::size_t Columns>
void run_kernel(InstructionSet set, const Lanes<Problem>& in, T* const (&out)[Columns]) {
  constexpr bool has_kernels = is_in<Kernels<Method, Problem>, KernelTable>;
  static_assert(has_kernels,
                "this method has no batch kernels for this input: call Method::roots in a loop instead");
  if constexpr (has_kernels) {
    const auto& kernels = kernels_for<Method, Problem>(set);
    if constexpr (Columns == 1) {
      kernels.nearest(in, out);
    } else {
      kernels.roots(in, out);
    }
  }
}

/// The columns of a batch of rays, valid as long as `rays`.
template <class T, template <class> class Shape>
[[nodiscard]] Lanes<RayProblem<Shape, T>> lanes_of(const RayBatch<T>& rays, const Shape<T>& shape) {
  const auto& [origin, direction, t_min, t_max, space] = rays;
  const std::size_t size = common_size(origin.x, origin.y, origin.z, direction.x, direction.y, direction.z);
  return {{origin.x.data(), origin.y.data(), origin.z.data(), direction.x.data(), direction.y.data(),
           direction.z.data()},
          size,
          t_min,
          t_max,
          shape,
          space.has_value(),
          space.value_or(ObjectSpace<T>{})};
}

}  // namespace batch

/// The nearest hit of each ray: the smallest root in [t_min, t_max], or infinity for a miss. `t` is as long
/// as the batch.
template <class Method, class T, template <class> class Shape>
void nearest_hits(const RayBatch<T>& rays, const Shape<T>& shape, std::type_identity_t<std::span<T>> t,
                  InstructionSet set = preferred_instruction_set()) {
  batch::common_size(rays.origin.x, t);
  batch::run_kernel<Method>(set, batch::lanes_of(rays, shape), {t.data()});
}

/// Both roots of each ray's problem, before the interval of t is looked at.
template <class Method, class T, template <class> class Shape>
void batch_roots(const RayBatch<T>& rays, const Shape<T>& shape, const RootArrays<T>& roots,
                 InstructionSet set = preferred_instruction_set()) {
  batch::common_size(rays.origin.x, roots.discriminant, roots.lo, roots.hi);
  batch::run_kernel<Method>(set, batch::lanes_of(rays, shape),
                            {roots.discriminant.data(), roots.lo.data(), roots.hi.data()});
}

/// Both roots of each equation.
template <class Method, class T>
void batch_roots(const QuadraticBatch<T>& equations, const RootArrays<T>& roots,
                 InstructionSet set = preferred_instruction_set()) {
  const auto& [a, b, c] = equations;
  const std::size_t size = batch::common_size(a, b, c, roots.discriminant, roots.lo, roots.hi);
  batch::run_kernel<Method>(set, batch::Lanes<Quadratic<T>>{{a.data(), b.data(), c.data()}, size},
                            {roots.discriminant.data(), roots.lo.data(), roots.hi.data()});
}

}  // namespace rayproof
