#pragma once
/// \file
/// The nearest hit alone, which the methods `rounded` find in fewer steps than both roots.

#include <rayproof/formulas/newton_step.hpp>
#include <rayproof/roots.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// Whether a method's nearest hit is found by correcting a plain one, wherever that leaves no doubt.
template <class Method>
inline constexpr bool has_correction = requires {
  typename Method::Correction;
};

/// The nearest hit by a correction, infinity for a miss, and whether it is sure to be the exact one rounded
/// once.
template <class Correction, std::floating_point T, template <class> class Shape>
[[nodiscard]] Corrected<T> corrected_nearest(const Ray<T>& ray, const Shape<T>& shape) {
  using W = WiderThan<T>;
  const auto known = prepared<Correction>(convert<W>(shape));
  const auto wide = [](const glm::vec<3, T>& v) {
    return vec3<W>{with_more_digits<W>(v.x), with_more_digits<W>(v.y), with_more_digits<W>(v.z)};
  };
  const CorrectionStart<T> start = Correction::start(ray, shape);
  const CorrectionStart<W> wide_start{with_more_digits<W>(start.t), with_more_digits<W>(start.face)};
  const Ray<W> wide_ray{wide(ray.origin), wide(ray.direction)};
  return Correction::nearest(ray, start, Correction::residual(ray, wide_ray, start, wide_start, known),
                             known);
}

/// The nearest hit by a method's correction, or by its roots where that is in doubt.
template <class Method, std::floating_point T, template <class> class Shape>
[[nodiscard]] T corrected_hit(const Ray<T>& ray, const Shape<T>& shape) {
  const auto corrected = corrected_nearest<typename Method::Correction>(ray, shape);
  return corrected.is_sure ? corrected.answer : nearest(ray, Method::roots(ray, shape));
}

/// The nearest hit by a method's quick phase, or by its exact one where that is in doubt.
template <class Method, std::floating_point T, template <class> class Shape>
[[nodiscard]] T quick_hit(const Ray<T>& ray, const Shape<T>& shape) {
  using W = WiderThan<T>;
  const auto known = Method::enclosed(convert<W>(ray), prepared<Method>(convert<W>(shape)));
  const auto quick = rounded_nearest(convert<double>(ray), known);
  return quick.is_sure ? static_cast<T>(quick.answer) : nearest(ray, Method::exact_roots(ray, shape));
}

/// The nearest hit of a ray in the shape's own space: the smallest root in [t_min, t_max], or infinity for a
/// miss; bit for bit `nearest(ray, Method::roots(ray, shape))`. One ray in double is met faster by a
/// correction; one in float is not, since it is in packs that floats are twice as fast as doubles.
template <class Method, std::floating_point T, template <class> class Shape>
[[nodiscard]] T nearest_hit(const Ray<T>& ray, const Shape<T>& shape) {
  if constexpr (has_correction<Method> && std::same_as<T, double>) {
    return corrected_hit<Method>(ray, shape);
  } else if constexpr (has_quick_phase<Method>) {
    return quick_hit<Method>(ray, shape);
  } else {
    return nearest(ray, Method::roots(ray, shape));
  }
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
