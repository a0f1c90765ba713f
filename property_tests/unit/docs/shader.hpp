#pragma once
/// \file
/// What the lambdas of docs/your-own-code.md call: functions as a shader has them, for own_code.py.

#include <glm/glm.hpp>

using glm::vec2, glm::vec3;

/// Where the line enters and leaves both intervals of t, or (-1, -1).
inline vec2 common(vec2 a, vec2 b) {
  const vec2 both(glm::max(a.x, b.x), glm::min(a.y, b.y));
  return both.x <= both.y ? both : vec2(-1);
}

/// A box about the origin, by the slabs of its three pairs of faces; the normal where the ray enters.
inline vec2 box_intersection(vec3 ro, vec3 rd, vec3 half_size, vec3& normal) {
  const vec3 middle = -ro / rd, reach = abs(half_size / rd), entry = middle - reach, exit = middle + reach;
  const vec2 t = common(vec2(glm::max(entry.x, entry.y), glm::min(exit.x, exit.y)), vec2(entry.z, exit.z));
  normal = -sign(rd) * vec3(equal(entry, vec3(t.x)));
  return t;
}

/// A circular cylinder between two points of its axis.
inline vec2 my_capped_cylinder(vec3 ro, vec3 rd, vec3 from, vec3 to, float radius) {
  const vec3 axis = to - from, f = ro - from;
  const float length2 = dot(axis, axis), d = dot(axis, rd), o = dot(axis, f);
  const float a = length2 * dot(rd, rd) - d * d, b = length2 * dot(f, rd) - o * d;
  const float D = b * b - a * (length2 * dot(f, f) - o * o - radius * radius * length2);
  if (D < 0) return vec2(-1);
  const vec2 caps = vec2(0 - o, length2 - o) / d;
  return common(vec2(-b - std::sqrt(D), -b + std::sqrt(D)) / a,
                vec2(glm::min(caps.x, caps.y), glm::max(caps.x, caps.y)));
}
