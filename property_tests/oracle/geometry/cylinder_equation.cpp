#include "oracle/geometry/cylinder_equation.hpp"

namespace rayproof::oracle {

CylinderEquation::CylinderEquation(const ObjectRay<Ring>& ray, const Cylinder<double>& cylinder)
    : origin(ray.origin),
      direction(ray.direction),
      radius(Ring(cylinder.rx) * Ring(cylinder.ry) * ray.scale),
      height(Ring(cylinder.height) * ray.scale),
      capped(cylinder.capped) {
  if (sign(ray.scale) < 0) {  // so that heights keep their order
    origin = Ring(-1.0) * origin;
    direction = Ring(-1.0) * direction;
    radius = -radius;
    height = -height;
  }
  for (Vector<Ring>* v : {&origin, &direction}) {
    v->x = v->x * Ring(cylinder.ry);
    v->y = v->y * Ring(cylinder.rx);
  }
}

bool CylinderEquation::is_axis_parallel() const { return sign(direction.x) == 0 && sign(direction.y) == 0; }

ExactQuadratic CylinderEquation::side() const {
  return {direction.x * direction.x + direction.y * direction.y,
          origin.x * direction.x + origin.y * direction.y,
          origin.x * origin.x + origin.y * origin.y - radius * radius};
}

/// The hit with the cap's plane that the line passes on its way in, or out, where it lies inside the rim. (On
/// the rim it is the side's hit, unless the line runs inside the side.)
void CylinderEquation::add_caps(std::vector<CylinderHit>& hits, bool of_entry) const {
  const bool is_ring = sign(height) == 0;  // an open cylinder of no height is all rim
  if (!(capped || is_ring) || sign(direction.z) == 0) return;
  const bool is_lower = (sign(direction.z) > 0) == of_entry;
  const Quotient t(is_lower ? -origin.z : height - origin.z, direction.z);
  const Ring x = origin.x * t.denominator() + direction.x * t.numerator();
  const Ring y = origin.y * t.denominator() + direction.y * t.numerator();
  const Ring r = radius * t.denominator();
  const int outside = sign(x * x + y * y - r * r);
  const bool is_rim_of_own = outside == 0 && is_axis_parallel();
  if ((capped && outside < 0) || is_rim_of_own) hits.push_back({t, false, is_rim_of_own, is_lower ? -1 : 1});
}

void CylinderEquation::add_side(std::vector<CylinderHit>& hits) const {
  if (is_axis_parallel()) return;
  const ExactQuadratic equation = side();
  const int discriminant = sign(equation.discriminant());
  if (discriminant < 0) return;
  for (const int which : {-1, 1}) {
    if (which > 0 && discriminant == 0) return;
    const ExactRoot t(equation, which);
    const ExactRoot z = t.affine_image(origin.z, direction.z);
    const int above_floor = z.compare(Ring(0.0));
    const int above_top = z.compare(height);
    if (above_floor < 0 || above_top > 0) continue;
    hits.push_back({t, true, above_floor == 0 || above_top == 0, 0});
  }
}

std::vector<CylinderHit> CylinderEquation::hits() const {
  // Convex with its caps: what goes in through a cap does so before it meets the side, and the other way out.
  std::vector<CylinderHit> all;
  add_caps(all, true);
  add_side(all);
  const bool is_flat = sign(height) == 0;  // the two caps are one
  if (!(is_flat && !all.empty())) add_caps(all, false);
  return all;
}

}  // namespace rayproof::oracle
