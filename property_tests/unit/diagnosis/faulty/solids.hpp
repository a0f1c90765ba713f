#pragma once
/// \file
/// Textbook spheres, boxes, parallelepipeds and cylinders with one fault each.

#include <algorithm>

#include "unit/diagnosis/faulty/ray_code.hpp"

namespace rayproof::faulty {

/// The quadratic formula, with the smaller root first.
template <class T>
[[nodiscard]] std::vector<T> real_roots(T a, T b, T c, Fault fault) {
  const T D = b * b - 4 * a * c;
  if (!(D >= 0)) return {};
  const T s = std::sqrt(D), q = T(-0.5) * (b + std::copysign(s, b));
  if (D == 0) {
    if (fault == Fault::tangent_missed) return {};
    const T t = -b / (fault == Fault::denominator_2ac ? 2 * a * c
                      : fault == Fault::denominator_a ? a
                                                      : 2 * a);
    return {t};
  }
  if (fault == Fault::denominator_2ac)
    return {std::min((-b - s) / (2 * a * c), (-b + s) / (2 * a * c)),
            std::max((-b - s) / (2 * a * c), (-b + s) / (2 * a * c))};
  if (fault == Fault::denominator_a) return {(-b - s) / a, (-b + s) / a};
  const T x = q / a, y = q == 0 ? -x : c / q;
  return {std::min(x, y), std::max(x, y)};
}

template <class T>
[[nodiscard]] FoundHits<T> find(const Ray<T>& ray, const Sphere<T>& sphere, Fault fault) {
  if (fault == Fault::no_radius_missed && sphere.radius == 0) return {};
  glm::vec<3, T> f = ray.origin - sphere.center;
  if (fault == Fault::centre_ignored) f = ray.origin;
  if (fault == Fault::centre_negated) f = ray.origin + sphere.center;
  const T r = fault == Fault::radius_is_diameter ? sphere.radius / 2 : sphere.radius;
  const T r2 = fault == Fault::radius_not_squared ? r : r * r;
  const T a = fault == Fault::unit_direction ? T(1) : dot(ray.direction, ray.direction);
  const T c = dot(f, f) - r2;
  FoundHits<T> found;
  if (fault == Fault::from_inside_missed && c < 0) return found;
  for (const T t : real_roots(a, 2 * dot(f, ray.direction), c, fault))
    found.hits.push_back({t, (f + t * ray.direction) / sphere.radius});
  if (found.hits.size() == 1) found.contact = Contact::tangent;
  return found;
}

/// The chord of the line through three slabs that are given by each axis' distances to the two planes and
/// the direction's component, with the normals of the planes.
template <class T>
[[nodiscard]] FoundHits<T> chord_of(const glm::vec<3, T>& below, const glm::vec<3, T>& above,
                                    const glm::vec<3, T>& d, const glm::vec<3, T> (&normals)[3],
                                    const T start, Fault fault) {
  T near = -std::numeric_limits<T>::infinity(), far = std::numeric_limits<T>::infinity();
  glm::vec<3, T> near_normal{}, far_normal{};
  for (int i = 0; i < 3; ++i) {
    if (i == 2 && (fault == Fault::slab_z_missing || fault == Fault::edge_missing)) continue;
    T low = below[i] / d[i], high = above[i] / d[i];
    if (d[i] == 0 && fault != Fault::zero_times_infinity) {
      if (below[i] > 0 || above[i] < 0) return {};
      continue;
    }
    const bool is_exchanged = low > high && fault != Fault::no_exchange;
    if (is_exchanged) std::swap(low, high);
    if (!(low <= near)) near = low, near_normal = is_exchanged ? normals[i] : -normals[i];
    if (!(high >= far)) far = high, far_normal = is_exchanged ? -normals[i] : normals[i];
  }
  if (!(near <= far)) return {};
  if (fault == Fault::starts_at_t_min && near < start && start <= far) near = start;
  if (near == far) return {{{near, near_normal}}, Contact::tangent};
  return {{{near, near_normal}, {far, far_normal}}};
}

template <class T>
[[nodiscard]] FoundHits<T> find(const Ray<T>& ray, const Box<T>& box, Fault fault) {
  const glm::vec<3, T> normals[3]{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return chord_of<T>(box.min - ray.origin, box.max - ray.origin, ray.direction, normals, ray.t_min, fault);
}

template <class T>
[[nodiscard]] FoundHits<T> find(const Ray<T>& ray, const Parallelepiped<T>& solid, Fault fault) {
  if (fault == Fault::as_box) {
    const glm::vec<3, T> a = solid.corner, b = a + solid.edges[0] + solid.edges[1] + solid.edges[2];
    return find(ray, Box<T>{glm::min(a, b), glm::max(a, b)}, fault);
  }
  const glm::vec<3, T> f = solid.corner - ray.origin;
  glm::vec<3, T> below{}, above{}, slope{}, normals[3];
  for (int i = 0; i < 3; ++i) {
    normals[i] = cross(solid.edges[(i + 1) % 3], solid.edges[(i + 2) % 3]);
    const T volume = dot(normals[i], solid.edges[i]);
    if (volume < 0) normals[i] = -normals[i];
    below[i] = dot(normals[i], f);
    above[i] = below[i] + std::abs(volume);
    slope[i] = dot(normals[i], ray.direction);
  }
  return chord_of<T>(below, above, slope, normals, ray.t_min, fault);
}

template <class T>
[[nodiscard]] FoundHits<T> find(const Ray<T>& ray, const Cylinder<T>& given, Fault fault) {
  Cylinder<T> c = given;
  if (fault == Fault::caps_always) c.capped = true;
  if (fault == Fault::caps_never) c.capped = false;
  if (fault == Fault::circle) c.ry = c.rx;
  const T low = fault == Fault::height_centred ? -c.height / 2 : T(0), high = low + c.height;
  const glm::vec<3, T> scale{1 / c.rx, 1 / c.ry, 0}, o = ray.origin * scale, d = ray.direction * scale;
  FoundHits<T> found;
  for (const T t : real_roots(dot(d, d), 2 * dot(o, d), dot(o, o) - 1, fault)) {
    const T z = ray.origin.z + t * ray.direction.z;
    if (fault == Fault::no_height || (low <= z && z <= high)) found.hits.push_back({t, (o + t * d) * scale});
  }
  for (const T z : {low, high}) {
    const T t = (z - ray.origin.z) / ray.direction.z;
    const glm::vec<3, T> q = o + t * d;
    const bool is_new = std::ranges::none_of(found.hits, [t](const auto& hit) {
      return std::abs(hit.t - t) <= 64 * std::numeric_limits<T>::epsilon() * std::abs(t);
    });
    if (c.capped && dot(q, q) <= (fault == Fault::caps_narrower ? T(0.95) : T(1)) && is_new)
      found.hits.push_back({t, {0, 0, z == low ? -1 : 1}});
  }
  std::ranges::sort(found.hits, {}, &FoundHits<T>::CodeHit::t);
  return found;
}

}  // namespace rayproof::faulty
