#pragma once
/// \file
/// Lengths of vectors and sizes of maps, read from the exact numbers and from the filters' alike: what the
/// units of the contracts are made of.

#include "oracle/geometry/scene.hpp"
#include "oracle/numbers/ball.hpp"
#include "oracle/numbers/exact.hpp"
#include "oracle/numbers/interval.hpp"
#include "oracle/numbers/pair.hpp"

namespace rayproof::oracle {

/// Numbers to read values by: doubles for the filters, which are used only where doubles do not overflow.
[[nodiscard]] inline double read(const Interval& x) { return x.middle; }
[[nodiscard]] inline double read(const Ball& x) { return x.high; }
[[nodiscard]] inline double read(const Pair& x) { return x.high; }
[[nodiscard]] inline Scaled read(const Ring& x) { return approximate(x); }
[[nodiscard]] inline Scaled read(const Scaled& x) { return x; }

template <class R>
using NumberOf = decltype(read(std::declval<R>()));

/// |v|².
template <class R>
[[nodiscard]] NumberOf<R> squared_norm(const Vector<R>& v) {
  const NumberOf<R> x = read(v.x), y = read(v.y), z = read(v.z);
  return x * x + y * y + z * z;
}
/// |v|.
template <class R>
[[nodiscard]] NumberOf<R> norm(const Vector<R>& v) {
  using std::sqrt;
  return sqrt(squared_norm(v));
}
[[nodiscard]] inline Scaled norm(const glm::dvec3& v) { return norm(Vector<Scaled>::from(v)); }

/// How much a map and its inverse can stretch a vector: the Frobenius norms of their 3 by 3 parts, the
/// inverse's times the determinant.
template <class R>
struct MapSizes {
  NumberOf<R> forward, backward;

  MapSizes(const glm::dmat4& m, const InverseMap<R>& map)
      : forward(frobenius(Vector<R>::from(m[0]), Vector<R>::from(m[1]), Vector<R>::from(m[2]))),
        backward(frobenius(map.row_x, map.row_y, map.row_z)) {}

 private:
  static NumberOf<R> frobenius(const Vector<R>& x, const Vector<R>& y, const Vector<R>& z) {
    using std::sqrt;
    return sqrt(squared_norm(x) + squared_norm(y) + squared_norm(z));
  }
};

}  // namespace rayproof::oracle
