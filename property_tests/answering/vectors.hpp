#pragma once
/// \file
/// Anybody's vectors: classes with the members x, y, z (GLM's, a user's own) and std::array.

#include <array>
#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace rayproof::answering {

/// How many numbers a class with the members x, y, z, w has; 0 for what is no such class.
template <class V>
[[nodiscard]] consteval std::size_t named_size() {
  if constexpr (std::is_void_v<V>) {
    return 0;
  } else if constexpr (!requires(V v) {
                         { v.x + v.x } -> std::floating_point;
                         v.y;
                       }) {
    return 0;
  } else if constexpr (requires(V v) { v.w; }) {
    return 4;
  } else if constexpr (requires(V v) { v.z; }) {
    return 3;
  } else {
    return 2;
  }
}

template <class V>
inline constexpr std::size_t array_size = 0;
template <std::floating_point T, std::size_t N>
inline constexpr std::size_t array_size<std::array<T, N>> = N;

/// A vector of N numbers that can be made of them.
template <class V, std::size_t N>
concept VectorOf = named_size<V>()
== N || array_size<V> == N;

/// The number type of a vector.
template <class V>
struct NumberOf;
template <class V>
requires(named_size<V>() > 0) struct NumberOf<V> {
  using Type = std::remove_cvref_t<decltype(std::declval<V>().x)>;
};
template <class T, std::size_t N>
struct NumberOf<std::array<T, N>> {
  using Type = T;
};

/// The vector of the numbers from `numbers` on, each rounded to the vector's type.
template <class V, std::size_t N>
[[nodiscard]] V make_vector(const double* numbers) {
  using T = typename NumberOf<V>::Type;
  if constexpr (N == 2) return V{static_cast<T>(numbers[0]), static_cast<T>(numbers[1])};
  if constexpr (N == 3)
    return V{static_cast<T>(numbers[0]), static_cast<T>(numbers[1]), static_cast<T>(numbers[2])};
}

/// The numbers of a class with the members x, y, z, w.
template <class V>
[[nodiscard]] auto numbers_of(const V& v) {
  constexpr std::size_t size = named_size<V>();
  std::array<double, size> all{static_cast<double>(v.x), static_cast<double>(v.y)};
  if constexpr (size > 2) all[2] = static_cast<double>(v.z);
  if constexpr (size > 3) all[3] = static_cast<double>(v.w);
  return all;
}

}  // namespace rayproof::answering
