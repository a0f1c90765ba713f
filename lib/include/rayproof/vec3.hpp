#pragma once
/// \file
/// Vectors of three numbers, GLM's where GLM can hold the number, a small look-alike where it cannot; and of
/// two.

#include <concepts>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <rayproof/arithmetic.hpp>
#include <type_traits>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// Three numbers of any arithmetic, with glm::vec3's member names. GLM's own class keeps its components in
/// unions, which a pack, a recorded number or an expansion cannot live in.
template <class T>
struct Vec3 {
  T x, y, z;
};

/// A point or vector of the plane.
template <class T>
struct Vec2 {
  T x, y;
};

template <class A, class B>
[[nodiscard]] constexpr auto operator+(const Vec3<A>& a, const Vec3<B>& b) {
  return Vec3<decltype(a.x + b.x)>{a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class A, class B>
[[nodiscard]] constexpr auto operator-(const Vec3<A>& a, const Vec3<B>& b) {
  return Vec3<decltype(a.x - b.x)>{a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class S, class A>
[[nodiscard]] constexpr auto operator*(const S& s, const Vec3<A>& v) {
  return Vec3<decltype(s * v.x)>{s * v.x, s * v.y, s * v.z};
}

/// The vector type of arithmetic `T`: `glm::vec3` for float, `glm::dvec3` for double, `Vec3<T>` otherwise.
template <class T>
using vec3 = std::conditional_t<std::floating_point<T>, glm::vec<3, T>, Vec3<T>>;

/// a·b + c·d + e·f. An arithmetic of several parts has a way of its own, in fewer steps.
template <class A, class B>
[[nodiscard]] constexpr auto sum_of_products(const A& a, const B& b, const A& c, const B& d, const A& e,
                                             const B& f) {
  return a * b + c * d + e * f;
}

/// x·y + z, with one rounding or two, as the arithmetic is faster at: where x·y is exact, and in bounds.
template <class T>
[[nodiscard]] constexpr T multiply_add(const T& x, const T& y, const T& z) {
  return x * y + z;
}

/// The same of each component: x·v + w.
template <class T, class V>
requires std::same_as<V, vec3<T>>
[[nodiscard]] constexpr V multiply_add(const T& x, const V& v, const V& w) {
  return {multiply_add(x, v.x, w.x), multiply_add(x, v.y, w.y), multiply_add(x, v.z, w.z)};
}

template <class A, class B>
[[nodiscard]] constexpr auto dot(const Vec3<A>& a, const Vec3<B>& b) {
  return sum_of_products(a.x, b.x, a.y, b.y, a.z, b.z);
}

/// GLM's own `dot` refuses non-IEEE types and may reorder under its SIMD switches; this one is always x, y,
/// z.
template <std::floating_point T>
[[nodiscard]] constexpr T dot(const glm::vec<3, T>& a, const glm::vec<3, T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// a × b, rounded operation by operation.
template <class A, class B>
[[nodiscard]] constexpr auto cross(const Vec3<A>& a, const Vec3<B>& b) {
  return Vec3<decltype(a.y * b.z - a.z * b.y)>{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                                               a.x * b.y - a.y * b.x};
}
template <std::floating_point T>
[[nodiscard]] constexpr glm::vec<3, T> cross(const glm::vec<3, T>& a, const glm::vec<3, T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// v / |v|; NaN where v is 0.
template <class T>
[[nodiscard]] vec3<T> normalized(const vec3<T>& v) {
  return (T(1) / sqrt(dot(v, v))) * v;
}
/// The same of however short or long a vector: the squares of plain numbers neither under- nor overflow.
template <class T>
[[nodiscard]] vec3<T> unit_vector(const vec3<T>& v) {
  if constexpr (std::floating_point<T>) {
    const T e = exponent(max(abs(v.x), max(abs(v.y), abs(v.z))));
    return normalized<T>({scale_exponent(v.x, -e), scale_exponent(v.y, -e), scale_exponent(v.z, -e)});
  } else {
    return normalized<T>(v);
  }
}

#include <rayproof/rounding/as_before.hpp>

/// The same vector in another arithmetic.
template <class To, class V>
[[nodiscard]] constexpr vec3<To> convert(const V& v) {
  return vec3<To>{To(v.x), To(v.y), To(v.z)};
}

}  // namespace rayproof
