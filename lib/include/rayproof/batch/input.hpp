#pragma once
/// \file
/// Many problems at once, laid out as a structure of arrays: what differs from lane to lane, and what is
/// common.

#include <cstddef>
#include <optional>
#include <rayproof/quadratic.hpp>
#include <rayproof/ray.hpp>
#include <rayproof/transform.hpp>
#include <span>

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

}  // namespace rayproof
