#pragma once
/// \file
/// Families drawn number by number, for any shape: any finite bits, numbers by name.

#include <algorithm>
#include <cstddef>

#include "generators/generators.hpp"
#include "generators/scene.hpp"

namespace rayproof {

/// Makes of numbers drawn at random a shape that the format can take: how many vertices there are, and the
/// signs and the order that it asks for. Overloaded for the shapes that ask for anything.
template <class S>
void prepare(Random& random, S& shape) {
  if constexpr (requires { shape.vertices; })
    shape.vertices.resize(static_cast<std::size_t>(random.between(3, 8)));
}

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
  prepare(random, shape);
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
    const double t0 = number();
    const double t1 = number();
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

/// Draws one number after another.
struct Numbers {
  Random& random;
  Precision precision;
  double (*draw)(Random&, Precision);

  [[nodiscard]] double operator()() const { return draw(random, precision); }
};

template <class... Shapes>
[[nodiscard]] Question any_shape(Numbers number) {
  return one_from_numbers<Shapes...>(number.random, number);
}
template <class Query>
[[nodiscard]] Question any_query(Numbers number) {
  return filled<Query>(number.random, number);
}

/// The questions that `ask` makes of any finite numbers.
template <Question (*ask)(Numbers)>
[[nodiscard]] Family bit_patterns(const char* topic, std::vector<MinimumShare> shares) {
  return {topic, "bit_patterns", "every finite bit pattern as likely as every other",
          [](Random& random, Precision precision) {
            return ask({random, precision, draw::bit_pattern});
          },
          std::move(shares)};
}

/// The questions that `ask` makes of numbers by name.
template <Question (*ask)(Numbers)>
[[nodiscard]] Family special(const char* topic, std::vector<MinimumShare> shares) {
  return {topic, "special", "0, -0, ±1, subnormals, the greatest number, powers of two, small integers",
          [](Random& random, Precision precision) {
            return ask({random, precision, draw::special});
          },
          std::move(shares)};
}

}  // namespace rayproof
