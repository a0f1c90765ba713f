#pragma once
/// \file
/// Families drawn number by number, for any shape: any finite bits, numbers by name.

#include <algorithm>
#include <cstddef>

#include "generators/accepted.hpp"
#include "generators/scene.hpp"

namespace rayproof {

/// Makes of numbers drawn at random a shape that the format can take: the signs and the order that it asks
/// for, and how many numbers there are. Overloaded for the shapes that ask for anything.
template <class S>
void prepare(Random& /*random*/, S& /*any*/) {}
inline void prepare(Random& random, Polygon<double>& polygon) {
  polygon.vertices.resize(static_cast<std::size_t>(random.between(3, 8)));
}

template <class S>
void settle(Random& /*random*/, S& /*any*/) {}
inline void settle(Random& /*random*/, Sphere<double>& sphere) { sphere.radius = std::abs(sphere.radius); }
inline void settle(Random& /*random*/, Box<double>& box) {
  for (int axis = 0; axis < 3; ++axis)
    if (box.max[axis] < box.min[axis]) std::swap(box.min[axis], box.max[axis]);
}
inline void settle(Random& random, Cylinder<double>& cylinder) {
  each_number(cylinder, [](double& x) { x = std::abs(x); });
  cylinder.capped = random.one_in(2);
}

/// A shape `S` and a ray of numbers from `number()`, and the whole line or the default interval.
template <class S, class Number>
[[nodiscard]] RayQuestion from_numbers(Random& random, Number&& number) {
  S shape{};
  prepare(random, shape);
  const auto fill = [&](double& x) { x = static_cast<double>(number()); };
  each_number(shape, fill);
  settle(random, shape);
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

struct BitPatternsText {
  static constexpr const char* name = "bit_patterns";
  static constexpr const char* description = "every finite bit pattern as likely as every other";
};
template <class... Shapes>
struct BitPatterns : BitPatternsText {
  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    return one_from_numbers<Shapes...>(random, [&] { return draw::bit_pattern<T>(random); });
  }
};

struct SpecialText {
  static constexpr const char* name = "special";
  static constexpr const char* description =
      "0, -0, ±1, subnormals, the greatest number, powers of two, small integers";
};
template <class... Shapes>
struct Special : SpecialText {
  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    return one_from_numbers<Shapes...>(random, [&] { return draw::special<T>(random); });
  }
};

}  // namespace rayproof
