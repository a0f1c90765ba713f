#include "viz/scene/bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/interval.hpp"

namespace rayproof::render {
namespace {

using oracle::Interval;
using IntervalPoint = std::array<Interval, 3>;

double below(const Interval& x) { return std::nextafter(x.middle - x.radius, -HUGE_VAL); }
double above(const Interval& x) { return std::nextafter(x.middle + x.radius, HUGE_VAL); }

/// Grows around the images of points under the object's transform.
class Hull {
 public:
  explicit Hull(const std::optional<glm::dmat4>& transform) : transform_(transform) {}

  void add(const IntervalPoint& p) {
    for (int axis = 0; axis < 3; ++axis) {
      const Interval x = image(p, axis);
      bounds_.low[axis] = std::min(bounds_.low[axis], below(x));
      bounds_.high[axis] = std::max(bounds_.high[axis], above(x));
      // Also false for NaN.
      is_sound_ = is_sound_ && below(x) > -largest_sound && above(x) < largest_sound;
    }
  }
  void add(const glm::dvec3& p) { add(IntervalPoint{p.x, p.y, p.z}); }

  /// The eight corners of low + {0, 1}·size on each axis.
  void add_box(const IntervalPoint& low, const IntervalPoint& high) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      add(IntervalPoint{(corner & 1U) != 0 ? high[0] : low[0], (corner & 2U) != 0 ? high[1] : low[1],
                        (corner & 4U) != 0 ? high[2] : low[2]});
    }
  }

  [[nodiscard]] std::optional<Bounds> bounds() const {
    if (is_sound_) return bounds_;
    return std::nullopt;
  }

 private:
  [[nodiscard]] Interval image(const IntervalPoint& p, int axis) const {
    if (!transform_) return p[static_cast<std::size_t>(axis)];
    const glm::dmat4& m = *transform_;
    return Interval(m[0][axis]) * p[0] + Interval(m[1][axis]) * p[1] + Interval(m[2][axis]) * p[2] +
           Interval(m[3][axis]);
  }

  const std::optional<glm::dmat4>& transform_;
  Bounds bounds_{glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};
  bool is_sound_ = true;
};

void add(Hull& hull, const Sphere<double>& sphere) {
  const Interval r = sphere.radius;
  const IntervalPoint c{sphere.center.x, sphere.center.y, sphere.center.z};
  hull.add_box({c[0] - r, c[1] - r, c[2] - r}, {c[0] + r, c[1] + r, c[2] + r});
}
void add(Hull& hull, const Triangle<double>& triangle) {
  for (const glm::dvec3& vertex : {triangle.a, triangle.b, triangle.c}) hull.add(vertex);
}
/// The Newell normal.
IntervalPoint normal_of(const Polygon<double>& polygon) {
  IntervalPoint normal{};
  glm::dvec3 from = polygon.vertices.back();
  for (const glm::dvec3& to : polygon.vertices) {
    for (int x = 0; x < 3; ++x) {
      const int y = (x + 1) % 3, z = (x + 2) % 3;
      Interval& sum = normal[static_cast<std::size_t>(x)];
      sum = sum + Interval(from[y]) * Interval(to[z]) - Interval(from[z]) * Interval(to[y]);
    }
    from = to;
  }
  return normal;
}

/// A polygon lies in its exact plane through the first vertex, from which the others may stand off: along the
/// axis that its projection drops, the box is as high as the plane rises over the other two.
void add(Hull& hull, const Polygon<double>& polygon) {
  const glm::dvec3 first = polygon.vertices.front();
  Bounds box{first, first};
  for (const glm::dvec3& vertex : polygon.vertices) box = box.around({vertex, vertex});
  const IntervalPoint normal = normal_of(polygon);
  const auto at_most = [&](int axis) {
    const Interval& n = normal[static_cast<std::size_t>(axis)];
    return (1 + 0x1p-40) * (std::abs(n.middle) + n.radius);
  };
  const auto at_least = [&](int axis) {
    const Interval& n = normal[static_cast<std::size_t>(axis)];
    return std::max(0.0, (1 - 0x1p-40) * std::abs(n.middle) - (1 + 0x1p-40) * n.radius);
  };
  const double largest_at_least = std::max({at_least(0), at_least(1), at_least(2)});
  Bounds grown = box;
  for (int axis = 0; axis < 3; ++axis) {
    if (at_most(axis) < largest_at_least) continue;  // not the axis that is dropped
    double rise = 0;
    for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
      const double reach = std::max(first[other] - box.low[other], box.high[other] - first[other]);
      const double slope = at_least(axis) > 0 ? std::min(1.0, at_most(other) / at_least(axis)) : 1;
      rise += (1 + 0x1p-40) * slope * reach;
    }
    rise *= 1 + 0x1p-40;
    grown.low[axis] = std::min(box.low[axis], below(Interval(first[axis]) - Interval(rise)));
    grown.high[axis] = std::max(box.high[axis], above(Interval(first[axis]) + Interval(rise)));
  }
  hull.add_box({grown.low.x, grown.low.y, grown.low.z}, {grown.high.x, grown.high.y, grown.high.z});
}
void add(Hull& hull, const rayproof::Box<double>& box) {
  hull.add_box({box.min.x, box.min.y, box.min.z}, {box.max.x, box.max.y, box.max.z});
}
void add(Hull& hull, const Parallelepiped<double>& solid) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    IntervalPoint p{solid.corner.x, solid.corner.y, solid.corner.z};
    for (unsigned edge = 0; edge < 3; ++edge) {
      if ((corner >> edge & 1U) == 0) continue;
      for (std::size_t axis = 0; axis < 3; ++axis)
        p[axis] = p[axis] + Interval(solid.edges[edge][static_cast<glm::length_t>(axis)]);
    }
    hull.add(p);
  }
}
void add(Hull& hull, const Cylinder<double>& cylinder) {
  hull.add_box({-cylinder.rx, -cylinder.ry, 0.0}, {cylinder.rx, cylinder.ry, cylinder.height});
}

}  // namespace

Bounds Bounds::around(const Bounds& other) const {
  return {glm::min(low, other.low), glm::max(high, other.high)};
}

Bounds Bounds::grown(double margin) const { return {low - margin, high + margin}; }

std::optional<Bounds> bounds_of(const Object& object) {
  return std::visit(
      [&]<class S>(const S& shape) -> std::optional<Bounds> {
        if constexpr (requires(Hull & hull) { add(hull, shape); }) {
          Hull hull(object.transform);
          add(hull, shape);
          return hull.bounds();
        } else {
          return std::nullopt;
        }
      },
      object.shape);
}

}  // namespace rayproof::render
