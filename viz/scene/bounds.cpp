#include "viz/scene/bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/geometry/newell.hpp"
#include "oracle/numbers/interval.hpp"

namespace rayproof::render {
namespace {

using oracle::Interval;
using Point = oracle::Vector<Interval>;

double below(const Interval& x) { return std::nextafter(x.middle - x.radius, -HUGE_VAL); }
double above(const Interval& x) { return std::nextafter(x.middle + x.radius, HUGE_VAL); }

std::array<Interval, 3> coordinates_of(const Point& p) { return {p.x, p.y, p.z}; }

/// Grows around the images of points under the object's transform.
class Hull {
 public:
  explicit Hull(const std::optional<glm::dmat4>& transform) : transform_(transform) {}

  void add(const Point& p) {
    int axis = 0;
    for (const Interval& x : coordinates_of(transform_ ? image(p) : p)) {
      bounds_.low[axis] = std::min(bounds_.low[axis], below(x));
      bounds_.high[axis] = std::max(bounds_.high[axis], above(x));
      // Also false for NaN.
      is_sound_ = is_sound_ && below(x) > -largest_sound && above(x) < largest_sound;
      ++axis;
    }
  }

  /// The eight corners of a box along the axes.
  void add_box(const Point& low, const Point& high) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      add(Point{(corner & 1U) != 0 ? high.x : low.x, (corner & 2U) != 0 ? high.y : low.y,
                (corner & 4U) != 0 ? high.z : low.z});
    }
  }

  [[nodiscard]] std::optional<Bounds> bounds() const {
    if (is_sound_) return bounds_;
    return std::nullopt;
  }

 private:
  [[nodiscard]] Point image(const Point& p) const {
    const glm::dmat4& m = *transform_;
    return p.x * Point::from(m[0]) + p.y * Point::from(m[1]) + p.z * Point::from(m[2]) + Point::from(m[3]);
  }

  const std::optional<glm::dmat4>& transform_;
  Bounds bounds_{glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};
  bool is_sound_ = true;
};

void add(Hull& hull, const Sphere<double>& sphere) {
  const auto center = Point::from(sphere.center);
  const auto reach = Point::from(glm::dvec3(sphere.radius));
  hull.add_box(center - reach, center + reach);
}
void add(Hull& hull, const Triangle<double>& triangle) {
  for (const glm::dvec3& vertex : {triangle.a, triangle.b, triangle.c}) hull.add(Point::from(vertex));
}

/// How high the plane of a polygon may rise from its first vertex over the others' distance along two axes,
/// if the third, `axis`, is the one that its projection drops; 0 where it is certainly not that one.
double rise_of(const std::array<Interval, 3>& normal, int axis, const glm::dvec3& reach) {
  constexpr double outwards = 1 + 0x1p-40;  // outweighs the roundings of these lines
  const auto at_most = [&](int i) {
    const Interval& n = normal[static_cast<std::size_t>(i)];
    return outwards * (std::abs(n.middle) + n.radius);
  };
  const auto at_least = [&](int i) {
    const Interval& n = normal[static_cast<std::size_t>(i)];
    return std::max(0.0, std::abs(n.middle) / outwards - outwards * n.radius);
  };
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  if (at_most(axis) < std::max(at_least(x), at_least(y))) return 0;
  const auto over = [&](int other) {
    const double slope = at_least(axis) > 0 ? std::min(1.0, at_most(other) / at_least(axis)) : 1;
    return outwards * slope * reach[other];
  };
  return outwards * (over(x) + over(y));
}

/// A polygon lies in its exact plane through the first vertex, from which the others may stand off: along the
/// axis that its projection drops, the box is as high as the plane rises over the other two.
void add(Hull& hull, const Polygon<double>& polygon) {
  const glm::dvec3 first = polygon.vertices.front();
  Bounds box{first, first};
  for (const glm::dvec3& vertex : polygon.vertices) box = box.around({vertex, vertex});
  const glm::dvec3 reach = glm::max(first - box.low, box.high - first);
  const auto normal = coordinates_of(oracle::newell_normal<Interval>(polygon));
  for (int axis = 0; axis < 3; ++axis) {
    const Interval from(first[axis]), rise(rise_of(normal, axis, reach));
    box.low[axis] = std::min(box.low[axis], below(from - rise));
    box.high[axis] = std::max(box.high[axis], above(from + rise));
  }
  hull.add_box(Point::from(box.low), Point::from(box.high));
}
void add(Hull& hull, const rayproof::Box<double>& box) {
  hull.add_box(Point::from(box.min), Point::from(box.max));
}
void add(Hull& hull, const Parallelepiped<double>& solid) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    auto p = Point::from(solid.corner);
    for (unsigned edge = 0; edge < 3; ++edge)
      if ((corner >> edge & 1U) != 0) p = p + Point::from(solid.edges[edge]);
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
