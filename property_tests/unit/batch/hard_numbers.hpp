#pragma once
/// \file
/// Hard numbers to compare kernels on, and the kernels.

#include <gtest/gtest.h>

#include <limits>
#include <rayproof/batch.hpp>
#include <rayproof/topics.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "generators/draw.hpp"
#include "generators/random.hpp"
#include "unit/bits.hpp"

namespace rayproof {

/// A coordinate: mostly of a usual scene, else any bits, a number by name, an infinity or NaN.
template <class T>
[[nodiscard]] T hard_number(Random& random) {
  switch (random.between(0, 15)) {
    case 0:
      return draw::bit_pattern<T>(random);
    case 1:
      return draw::special<T>(random);
    case 2:
      return static_cast<T>(random.between(-4, 4));
    case 3:
      return random.one_in(8) ? std::numeric_limits<T>::quiet_NaN() : std::numeric_limits<T>::infinity();
    default:
      return static_cast<T>(3) * draw::symmetric<T>(random);
  }
}

/// `size` hard numbers.
template <class T>
[[nodiscard]] std::vector<T> hard_column(Random& random, std::size_t size) {
  std::vector<T> column(size);
  for (T& x : column) x = hard_number<T>(random);
  return column;
}

/// A vector of three numbers from `number()`.
template <class T>
[[nodiscard]] vec3<T> vector_of(const auto& number) {
  const T x = number(), y = number(), z = number();
  return {x, y, z};
}

/// A shape of numbers from `number()`.
template <class T>
void draw_of(Sphere<T>& sphere, Random& /*random*/, const auto& number) {
  sphere = {vector_of<T>(number), std::abs(number())};
}
template <class T>
void draw_of(Plane<T>& plane, Random& random, const auto& number) {
  const auto form = static_cast<PlaneForm>(random.between(0, 2));
  plane = {form,     vector_of<T>(number), vector_of<T>(number),
           number(), vector_of<T>(number), vector_of<T>(number)};
}
template <class T>
void draw_of(Triangle<T>& triangle, Random& /*random*/, const auto& number) {
  triangle = {vector_of<T>(number), vector_of<T>(number), vector_of<T>(number)};
}
template <class T>
void draw_of(Box<T>& box, Random& /*random*/, const auto& number) {
  box = {vector_of<T>(number), vector_of<T>(number)};
  for (int axis = 0; axis < 3; ++axis)
    if (box.max[axis] < box.min[axis]) std::swap(box.min[axis], box.max[axis]);
}
template <class T>
void draw_of(Parallelepiped<T>& shape, Random& /*random*/, const auto& number) {
  shape.corner = vector_of<T>(number);
  for (auto& edge : shape.edges) edge = vector_of<T>(number);
}
template <class T>
void draw_of(Cylinder<T>& cylinder, Random& random, const auto& number) {
  cylinder = {std::abs(number()), std::abs(number()), std::abs(number()), random.one_in(2)};
}

/// A vector, or a shape, of hard numbers.
template <class T>
[[nodiscard]] vec3<T> hard_vector(Random& random) {
  return vector_of<T>([&] { return hard_number<T>(random); });
}
template <template <class> class Shape, class T>
void draw_hard(Shape<T>& shape, Random& random) {
  draw_of(shape, random, [&] { return hard_number<T>(random); });
}

/// Calls `check(method, T{}, set)` for every method of a topic, in both precisions, on every instruction set
/// the machine has; once for a method without kernels.
template <class Topic, class Check>
void for_each_kernel(Check&& check) {
  Topic::Methods::for_each([&]<class Method>(std::type_identity<Method> method) {
    for (const InstructionSet set : available_instruction_sets()) {
      if (set != InstructionSet::baseline && !batch::has_kernels<Method>) continue;
      SCOPED_TRACE(std::string(Method::name) + " on " + std::string(name_of(set)));
      check(method, float{}, set);
      check(method, double{}, set);
    }
  });
}

/// Calls `check(topic)`, a null pointer to each topic of rays that has batches. Returns how many there are.
template <class Check>
std::size_t for_each_ray_topic(Check&& check) {
  std::size_t shapes = 0;
  Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
    if constexpr (is_batched<Topic> && !std::is_same_v<Topic, quadratic::Topic>) {
      ++shapes;
      SCOPED_TRACE(Topic::name);
      check(static_cast<const Topic*>(nullptr));
    }
  });
  return shapes;
}

}  // namespace rayproof
