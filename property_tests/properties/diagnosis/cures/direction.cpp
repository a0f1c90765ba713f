#include <algorithm>
#include <cmath>

#include "properties/diagnosis/cures/cures.hpp"

namespace rayproof::diagnosis {
namespace {

/// The ray with another direction that passes through the same point at t.
void turn_about(Ray<double>& ray, double t, const glm::dvec3& direction) {
  ray.origin += t * (ray.direction - direction);
  ray.direction = direction;
}

/// The t of the first hit of the line; 0 where it misses.
double first_t(const Case& one) {
  const RayAnswer line = hits_of_line(one);
  return line.hits.count > 0 && std::isfinite(line.hits.t[0]) ? line.hits.t[0] : 0;
}

/// The same points of the ray with a direction that is divided by `length`.
Cases with_direction_over(const Case& one, double length) {
  return with_question(one, [length](RayQuestion& asked) {
    asked.ray.direction /= length;
    asked.ray.t_min *= length;
    asked.ray.t_max *= length;
    return length != 1;
  });
}

bool has_minus_zero(Case one) {
  for (const CaseNumber& number : numbers_of(one))
    if (*number.value == 0 && std::signbit(*number.value)) return true;
  return false;
}

}  // namespace

Cases unit_direction(const Case& one) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return {};
  Cases all = with_direction_over(one, glm::length(asked->ray.direction));
  // Or it is of length 1 where the shape is.
  if (asked->transform)
    for (Case& other : with_direction_over(one, glm::length(ray_in_object(*asked).direction)))
      all.push_back(std::move(other));
  return all;
}

Cases tilted(const Case& one) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return {};
  const glm::dvec3 d = asked->ray.direction;
  if (d.x != 0 && d.y != 0 && d.z != 0) return {};
  const double t = first_t(one), size = 0x1p-10 * glm::length(d);
  Cases all;
  for (unsigned signs = 0; signs < 8; ++signs) {
    const auto changed = with_question(one, [&](RayQuestion& other) {
      glm::dvec3 direction = d;
      for (int axis = 0; axis < 3; ++axis) {
        const bool is_minus = (signs >> static_cast<unsigned>(axis) & 1U) != 0;
        if (d[axis] == 0) direction[axis] = is_minus ? -size : size;
        if (d[axis] != 0 && is_minus) return false;  // the same as without it
      }
      turn_about(other.ray, t, direction);
      return true;
    });
    all.insert(all.end(), changed.begin(), changed.end());
  }
  return all;
}

namespace {

/// Takes components away that are tiny beside the others; false where there are none.
bool take_tiny_away(glm::dvec3& d) {
  const double tiny = 0x1p-20 * std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  bool has_tiny = false;
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0 || std::abs(d[axis]) > tiny) continue;
    d[axis] = 0;
    has_tiny = true;
  }
  return has_tiny;
}

}  // namespace

Cases without_tiny_component(const Case& one) {
  Cases changed = with_question(one, [](RayQuestion& asked) { return take_tiny_away(asked.ray.direction); });
  if (!changed.empty()) return changed;
  return with_question(one, [](RayQuestion& asked) {  // rounding may leave one in the object's space
    if (!asked.transform) return false;
    asked.ray = ray_in_object(asked);
    asked.transform.reset();
    return take_tiny_away(asked.ray.direction);
  });
}

Cases positive_direction(const Case& one) {
  return with_shape<Box<double>>(one, [](RayQuestion& asked, Box<double>& box) {
    bool is_mirrored = false;
    for (int axis = 0; axis < 3; ++axis) {
      if (asked.ray.direction[axis] >= 0) continue;
      asked.ray.direction[axis] *= -1;
      asked.ray.origin[axis] *= -1;
      std::swap(box.min[axis], box.max[axis]);
      box.min[axis] *= -1;
      box.max[axis] *= -1;
      is_mirrored = true;
    }
    return is_mirrored && !asked.transform;
  });
}

Cases without_minus_zero(const Case& one) {
  if (!has_minus_zero(one)) return {};
  Case changed = one;
  for (const CaseNumber& number : numbers_of(changed)) *number.value += 0.0;
  return if_valid(changed);
}

}  // namespace rayproof::diagnosis
