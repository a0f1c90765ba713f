#pragma once
/// \file
/// What of a parallelepiped does not depend on the ray, with sizes for the bounds on its rounding.

#include <array>
#include <rayproof/arithmetics/sized.hpp>
#include <rayproof/parallelepiped.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::parallelepiped {

/// A pair of faces: the normal, which is the cross product of the two edges that span them, and what it makes
/// of the third, which leads from one to the other.
template <class W>
struct FacePair {
  Vec3<Sized<W>> normal;
  Sized<W> apart;
};

/// A solid before it meets a ray.
template <class W>
struct Prepared {
  vec3<W> corner;
  std::array<FacePair<W>, 3> pairs;
};

/// The same in another arithmetic.
template <class To, class From>
[[nodiscard]] constexpr FacePair<To> convert(const FacePair<From>& pair) {
  return {rayproof::convert<Sized<To>>(pair.normal), Sized<To>(pair.apart)};
}
template <class To, class From>
[[nodiscard]] constexpr Prepared<To> convert(const Prepared<From>& solid) {
  const auto& [first, second, third] = solid.pairs;
  return {rayproof::convert<To>(solid.corner), {convert<To>(first), convert<To>(second), convert<To>(third)}};
}

/// In line always: at -O2 g++ hands what this returns through memory, which takes half as long again.
template <class W>
[[nodiscard, gnu::always_inline]] constexpr Prepared<W> prepared_faces(const Parallelepiped<W>& solid) {
  const auto pair = [&](std::size_t j, std::size_t k, std::size_t i) -> FacePair<W> {
    const auto& e = solid.edges;
    const Vec3<Sized<W>> normal = sized_cross<W>(e[j], e[k]);
    return {normal, dot(normal, sized<W>(e[i]))};
  };
  return {solid.corner, {pair(1, 2, 0), pair(2, 0, 1), pair(0, 1, 2)}};
}

}  // namespace rayproof::parallelepiped

#include <rayproof/rounding/as_before.hpp>
