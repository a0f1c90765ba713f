#pragma once
/// \file
/// A line and an elliptic cylinder: the quadratic of its side, the quotients of its caps' planes, and the
/// hits.

#include "oracle/geometry/intersection.hpp"

namespace rayproof::oracle {

/// The cylinder in the scale of ObjectRay, with x and y stretched by ry and rx: the side is X² + Y² = R².
template <class R>
struct CylinderEquation {
  Vector<R> origin, direction;  ///< (ry·x, rx·y, z) of the ray, times the scale
  R radius;                     ///< rx·ry, times the scale
  R height;                     ///< times the scale

  CylinderEquation(const ObjectRay<R>& ray, const Cylinder<double>& cylinder)
      : origin(ray.origin),
        direction(ray.direction),
        radius(ray.scaled(R(cylinder.rx) * R(cylinder.ry))),
        height(ray.scaled(R(cylinder.height))) {
    for (Vector<R>* v : {&origin, &direction}) {
      v->x = v->x * R(cylinder.ry);
      v->y = v->y * R(cylinder.rx);
    }
  }

  [[nodiscard]] bool is_axis_parallel() const { return sign(direction.x) == 0 && sign(direction.y) == 0; }

  /// X² + Y² - R² along the line, a quadratic in t; all zero in a where the line is parallel to the axis.
  [[nodiscard]] QuadraticOver<R> side() const {
    return {direction.x * direction.x + direction.y * direction.y,
            origin.x * direction.x + origin.y * direction.y,
            origin.x * origin.x + origin.y * origin.y - radius * radius};
  }
  /// X² + Y² - R² at t, times the square of t's denominator.
  [[nodiscard]] R power_at(const QuotientOf<R>& t) const {
    const R x = origin.x * t.denominator() + direction.x * t.numerator();
    const R y = origin.y * t.denominator() + direction.y * t.numerator();
    const R r = radius * t.denominator();
    return x * x + y * y - r * r;
  }
  /// z at t, times t's denominator.
  [[nodiscard]] R height_at(const QuotientOf<R>& t) const {
    return origin.z * t.denominator() + direction.z * t.numerator();
  }
  /// z at t.
  [[nodiscard]] RootOf<R> height_at(const RootOf<R>& t) const {
    return t.affine_image(origin.z, direction.z);
  }
  /// Where the line, not parallel to the caps, meets the plane of one.
  [[nodiscard]] QuotientOf<R> cap(bool is_lower) const {
    return {is_lower ? -origin.z : height - origin.z, direction.z};
  }
};

/// The hits in the ray's interval, ascending, each once. The cylinder is convex with its caps: what goes in
/// through a cap does so before it meets the side, and the other way out.
template <class R>
class CylinderHits {
 public:
  using Number = std::variant<QuotientOf<R>, RootOf<R>>;
  using All = boost::container::static_vector<HitAt<Number>, 2>;

  CylinderHits(const CylinderEquation<R>& equation, const Cylinder<double>& cylinder, const Ray<double>& ray)
      : equation_(equation), cylinder_(cylinder), ray_(ray) {}

  [[nodiscard]] All operator()() {
    add_cap(true);
    add_side();
    if (cylinder_.height > 0) add_cap(false);  // the two caps of a cylinder of no height are one
    return std::move(all_);
  }

 private:
  /// The hit with the cap's plane that the line passes on its way in, or out, where it lies inside the rim.
  /// (On the rim it is the side's hit, unless the line runs inside the side.)
  void add_cap(bool of_entry) {
    const bool is_ring = cylinder_.height == 0;  // an open cylinder of no height is all rim
    if (!(cylinder_.capped || is_ring)) return;
    const int climb = sign(equation_.direction.z);
    if (climb == 0) return;
    QuotientOf<R> t = equation_.cap((climb > 0) == of_entry);
    const int outside = sign(equation_.power_at(t));
    const bool is_rim_of_own = outside == 0 && equation_.is_axis_parallel();
    if (is_rim_of_own || (cylinder_.capped && outside < 0))
      add(std::move(t), is_rim_of_own ? Contact::rim : Contact::crossing);
  }

  void add_side() {
    if (equation_.is_axis_parallel()) return;
    RootsOf<R> roots = real_roots(equation_.side());
    const Contact off_rim = roots.size() == 1 ? Contact::tangent : Contact::crossing;
    for (RootOf<R>& t : roots) {
      const RootOf<R> z = equation_.height_at(t);
      const int above_floor = z.compare(R(0.0)), above_top = z.compare(equation_.height);
      if (above_floor < 0 || above_top > 0) continue;
      const bool is_on_rim = above_floor == 0 || above_top == 0;
      add(std::move(t), is_on_rim ? Contact::rim : off_rim);
    }
  }

  template <class T>
  void add(T t, Contact contact) {
    // A third hit comes of a sign in doubt alone; what is found then is of no use.
    if (Doubt::is_noted() && all_.size() == all_.capacity()) return;
    if (is_in_interval(t, ray_.t_min, ray_.t_max)) all_.push_back({std::move(t), contact});
  }

  const CylinderEquation<R>& equation_;
  const Cylinder<double>& cylinder_;
  const Ray<double>& ray_;
  All all_;
};

}  // namespace rayproof::oracle
