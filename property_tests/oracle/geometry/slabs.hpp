#pragma once
/// \file
/// The three pairs of parallel planes of a convex solid and a line, exactly: what box and parallelepiped
/// share.

#include <array>

#include "oracle/geometry/intersection.hpp"
#include "oracle/numbers/quotient.hpp"

namespace rayproof::oracle {

/// A line and a slab, all q with low <= normal·q <= high: low <= position + t·speed <= high in the scale of
/// ObjectRay.
template <class R>
struct SlabMeeting {
  Vector<R> normal;  ///< in the object's space
  R position, speed, low, high;

  SlabMeeting(const ObjectRay<R>& ray, const Vector<R>& n, const R& lower, const R& upper)
      : SlabMeeting(ray, n, {dot(n, ray.origin), dot(n, ray.direction)}, lower, upper) {}
  /// The planes across an axis of the object's space.
  SlabMeeting(const ObjectRay<R>& ray, int axis, const R& lower, const R& upper)
      : SlabMeeting(ray, along(axis), {ray.origin[axis], ray.direction[axis]}, lower, upper) {}

  [[nodiscard]] bool is_parallel() const { return sign(speed) == 0; }
  /// Whether a line that is parallel to the slab runs in it.
  [[nodiscard]] bool is_inside() const { return sign(position - low) >= 0 && sign(high - position) >= 0; }
  /// The t at which the line comes into the slab, and at which it leaves.
  [[nodiscard]] QuotientOf<R> entry() const { return {(sign(speed) > 0 ? low : high) - position, speed}; }
  [[nodiscard]] QuotientOf<R> exit() const { return {(sign(speed) > 0 ? high : low) - position, speed}; }
  /// position + t·speed, times the denominator of t.
  [[nodiscard]] R at(const QuotientOf<R>& t) const {
    return position * t.denominator() + speed * t.numerator();
  }
  /// The same less a bound.
  [[nodiscard]] R beyond(const R& bound, const QuotientOf<R>& t) const {
    return at(t) - bound * t.denominator();
  }

 private:
  struct PositionAndSpeed {
    R position, speed;
  };
  SlabMeeting(const ObjectRay<R>& ray, const Vector<R>& n, PositionAndSpeed line, const R& lower,
              const R& upper)
      : normal(n),
        position(std::move(line.position)),
        speed(std::move(line.speed)),
        low(ray.scaled(lower)),
        high(ray.scaled(upper)) {}

  static Vector<R> along(int axis) {
    glm::dvec3 normal(0);
    normal[axis] = 1;
    return Vector<R>::from(normal);
  }
};
template <class R>
using SlabMeetings = std::array<SlabMeeting<R>, 3>;

template <class R>
[[nodiscard]] SlabMeetings<R> meetings(const ObjectRay<R>& ray, const Box<double>& box) {
  const auto slab = [&](int axis) { return SlabMeeting<R>(ray, axis, R(box.min[axis]), R(box.max[axis])); };
  return {slab(0), slab(1), slab(2)};
}

template <class R>
[[nodiscard]] SlabMeetings<R> meetings(const ObjectRay<R>& ray, const Parallelepiped<double>& solid) {
  const auto corner = Vector<R>::from(solid.corner);
  const auto edge = [&](std::size_t i) { return Vector<R>::from(solid.edges[i % 3]); };
  std::array normals{cross(edge(1), edge(2)), cross(edge(2), edge(0)), cross(edge(0), edge(1))};
  R volume = dot(normals[0], edge(0));  // of each normal and its edge
  if (sign(volume) < 0) {
    volume = -volume;
    for (Vector<R>& normal : normals) normal = -normal;
  }
  const auto slab = [&](std::size_t i) {
    const R low = dot(normals[i], corner);
    return SlabMeeting<R>(ray, normals[i], low, low + volume);
  };
  return {slab(0), slab(1), slab(2)};
}

/// Where the line is in all slabs at once, as far as the ray goes: its two ends, or the one that they are.
template <class R>
[[nodiscard]] auto hits_of(const SlabMeetings<R>& slabs, const Ray<double>& ray) {
  boost::container::static_vector<HitAt<QuotientOf<R>>, 2> all;
  std::optional<QuotientOf<R>> entry, exit;  // the normals are independent: no line is parallel to all slabs
  for (const SlabMeeting<R>& slab : slabs) {
    if (slab.is_parallel() && !slab.is_inside()) return all;
    if (slab.is_parallel()) continue;
    QuotientOf<R> in = slab.entry(), out = slab.exit();
    if (!entry || in.compare(*entry) > 0) entry = std::move(in);
    if (!exit || out.compare(*exit) < 0) exit = std::move(out);
  }
  const int length = exit->compare(*entry);
  const auto add = [&](QuotientOf<R>& t, Contact contact) {
    if (is_in_interval(t, ray.t_min, ray.t_max)) all.push_back({std::move(t), contact});
  };
  if (length >= 0) add(*entry, length == 0 ? Contact::tangent : Contact::crossing);
  if (length > 0) add(*exit, Contact::crossing);
  return all;
}

}  // namespace rayproof::oracle
