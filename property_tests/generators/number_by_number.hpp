#pragma once
/// \file
/// Families drawn number by number, for any shape: any finite bits, numbers by name.

#include <algorithm>
#include <cstddef>

#include "generators/generators.hpp"
#include "generators/scene.hpp"

namespace rayproof {

/// Makes of numbers drawn at random a shape that the format can take: the signs and the order that it asks
/// for. Overloaded for the shapes that ask for anything.
template <class S>
void make_valid(Random& /*random*/, S& /*any*/) {}
inline void make_valid(Random& /*random*/, Sphere<double>& sphere) {
  sphere.radius = std::abs(sphere.radius);
}
inline void make_valid(Random& /*random*/, Box<double>& box) {
  for (int axis = 0; axis < 3; ++axis)
    if (box.max[axis] < box.min[axis]) std::swap(box.min[axis], box.max[axis]);
}
inline void make_valid(Random& random, Cylinder<double>& cylinder) {
  each_number(cylinder, [](double& x) { x = std::abs(x); });
  cylinder.capped = random.one_in(2);
}

/// A shape, or a question without a ray, of numbers from `number()`.
template <class S>
[[nodiscard]] S filled(Random& random, auto&& number) {
  S shape{};
  if constexpr (requires { shape.vertices; })
    shape.vertices.resize(static_cast<std::size_t>(random.between(3, 8)));
  each_number(shape, [&](double& x) { x = static_cast<double>(number()); });
  make_valid(random, shape);
  return shape;
}

/// A shape `S` and a ray of numbers from `number()`, and the whole line or the default interval.
template <class S>
[[nodiscard]] RayQuestion from_numbers(Random& random, auto&& number) {
  const auto fill = [&](double& x) { x = static_cast<double>(number()); };
  const auto shape = filled<S>(random, number);
  Ray<double> ray{};
  each_number(ray.origin, fill);
  do {
    each_number(ray.direction, fill);
  } while (ray.direction == glm::dvec3(0));
  if (random.one_in(4)) {
    const double t0 = number(), t1 = number();
    ray.t_min = std::min(t0, t1);
    ray.t_max = std::max(t0, t1);
  }
  return {ray, shape};
}

/// The same for one of several shapes, as often as it takes for the format to take it.
template <class... Shapes, class Number>
[[nodiscard]] RayQuestion one_from_numbers(Random& random, Number&& number) {
  using Make = RayQuestion (*)(Random&, Number&);
  static constexpr Make makes[] = {[](Random& r, Number& n) { return from_numbers<Shapes>(r, n); }...};
  return first_accepted([&] {
    const int last = static_cast<int>(sizeof...(Shapes)) - 1;
    return makes[last == 0 ? 0 : random.between(0, last)](random, number);
  });
}

/// A question about one of the shapes, or one without a ray, of numbers that `draw` draws one after another.
template <double (*draw)(Random&, Precision), class... Shapes>
[[nodiscard]] Question ask_of_numbers(Random& random, Precision precision) {
  const auto number = [&] { return draw(random, precision); };
  if constexpr ((std::is_constructible_v<Shape, Shapes> && ...))
    return one_from_numbers<Shapes...>(random, number);
  else
    return filled<Shapes...>(random, number);
}

/// Questions of any finite numbers.
template <class... Shapes>
[[nodiscard]] Family bit_patterns(std::vector<MinimumShare> shares) {
  return {"bit_patterns", "every finite bit pattern as likely as every other",
          ask_of_numbers<draw::bit_pattern, Shapes...>, std::move(shares)};
}

/// Questions of numbers by name.
template <class... Shapes>
[[nodiscard]] Family special(std::vector<MinimumShare> shares) {
  return {"special", "0, -0, ±1, subnormals, the greatest number, powers of two, small integers",
          ask_of_numbers<draw::special, Shapes...>, std::move(shares)};
}

}  // namespace rayproof
