/// \file
/// The judgement of what an answer says of its first hit beside t: point, normal, barycentric coordinates.

#include <algorithm>
#include <numbers>

#include "oracle/geometry/sizes.hpp"
#include "oracle/judge/judging.hpp"

namespace rayproof::oracle {
namespace {

[[nodiscard]] bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The length of what a rounding of p(t) may be off by, but for ε: |origin| + |t||direction|, and what
/// underflow loses.
Scaled size_of_point(const Ray<double>& ray, const Quotient& t, Precision precision) {
  const Scaled smallest = precision == Precision::float32 ? Scaled(1, -149) : Scaled(1, -1074);
  return norm(ray.origin) + abs(t.estimate()) * norm(ray.direction) +
         smallest / Scaled(unit_roundoff(precision));
}

/// |claimed - p(t)|; a coordinate that overflows counts as off by nothing where that of p(t) does.
template <class Number>
Scaled off_point(const Ray<double>& ray, const Number& t, const glm::dvec3& claimed, Precision precision) {
  Vector<Scaled> apart{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto exact = t.affine_image(Ring(ray.origin[axis]), Ring(ray.direction[axis]));
    Scaled& gap = axis == 0 ? apart.x : axis == 1 ? apart.y : apart.z;
    if (std::isfinite(claimed[axis]))
      gap = exact.minus(claimed[axis]);
    else if (round_correctly(exact, precision) != claimed[axis])
      gap = endless();
  }
  return norm(apart);
}

/// A point of the world as the shape has it, in the scale of ObjectRay.
Vector<Ring> in_object(const ExactIntersection& exact, const glm::dvec3& point) {
  const auto own = Vector<Ring>::from(point);
  const auto& map = exact.ray().map;
  return map ? map->apply(own - map->translation) : own;
}

/// The angle between two vectors, from 0 to π.
double angle(const Vector<Scaled>& a, const Vector<Scaled>& b) {
  return static_cast<double>(std::atan2(norm(cross(a, b)).value(), dot(a, b).value()));
}

/// The normal of a part as the world has it, with the power of 2 of its length taken out, and by what factor
/// errors may turn it.
struct WorldNormal {
  Vector<Scaled> along;
  Scaled condition;

  WorldNormal(const ExactIntersection& exact, const SurfacePart& part, const Quotient& t)
      : along{}, condition(part.condition) {
    Vector<Ring> normal = part.normal.offset;
    if (part.normal.slope) normal = t.denominator() * normal + t.numerator() * *part.normal.slope;
    Scaled length = norm(normal);
    const auto& map = exact.ray().map;
    if (map) {
      const Scaled own_length = length;
      normal = map->apply_transposed(normal);
      length = norm(normal);
      condition =
          condition * own_length * MapSizes<Ring>(*exact.question().transform, *map).backward / length;
    }
    const Vector<Scaled> read_normal{approximate(normal.x), approximate(normal.y), approximate(normal.z)};
    along = {read_normal.x / length, read_normal.y / length, read_normal.z / length};
  }
};

/// By how much a claimed normal turns away from that of the part that it fits best, in units of the part's
/// condition, or by how much farther than the nearest part that one is, whichever is more; or how far it is
/// from unit length.
Scaled error_of_normal(const ExactIntersection& exact, const SurfaceParts& parts, const Quotient& t,
                       const glm::dvec3& claimed) {
  Scaled nearest = endless(), least = endless();
  for (const SurfacePart& part : parts) reduce(nearest, part.apart);
  const auto own = Vector<Scaled>::from(claimed);
  for (const SurfacePart& part : parts) {
    const WorldNormal normal(exact, part, t);
    const Scaled turn = Scaled(angle(own, normal.along)) / normal.condition;
    reduce(least, std::max(turn, part.apart - nearest));
  }
  const auto exactly = Vector<Ring>::from(claimed);
  const Scaled length = abs(approximate(dot(exactly, exactly) - Ring(1.0))) / Scaled(2);
  return std::max(least, length);
}

/// Of no normal, where the surface has one: as if it were the worst. Near an edge, where it has several, as
/// much as p(t) is farther from the second part than from the nearest.
Scaled error_of_no_normal(const ExactIntersection& exact, const SurfaceParts& parts, const Quotient& t) {
  const auto by_distance = [](const SurfacePart& a, const SurfacePart& b) { return a.apart < b.apart; };
  const auto nearest = std::ranges::min_element(parts, by_distance);
  Scaled least = Scaled(std::numbers::pi) / WorldNormal(exact, *nearest, t).condition;
  for (const SurfacePart& part : parts)
    if (&part != &*nearest) reduce(least, part.apart - nearest->apart);
  return least;
}

/// The largest error of a coordinate; endless where one is no number.
template <std::size_t count, class Claimed>
Scaled error_of_coordinates(const std::array<Quotient, count>& exact, const Claimed& claimed) {
  Scaled most;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    if (!std::isfinite(claimed[i])) return endless();
    most = std::max(most, abs(exact.at(static_cast<std::size_t>(i)).minus(claimed[i])));
  }
  return most;
}

}  // namespace

Details judge_details(const ExactIntersection& exact, Precision precision, const RayAnswer& claimed) {
  Details details;
  const ExactContacts hits = exact.hits();
  if (!hits.empty()) details.contact = hits.front().contact;
  if (claimed.hits.count == 0 || !std::isfinite(claimed.hits.t[0])) return details;
  const Ray<double>& ray = exact.question().ray;
  const Quotient t(claimed.hits.t[0]);
  const auto units = [&](const Scaled& error) { return in_units(error, precision); };
  details.point = details.surface = HUGE_VAL;
  if (claimed.point) {
    const Scaled size = size_of_point(ray, t, precision);
    details.point = units(off_point(ray, t, *claimed.point, precision) / size);
    if (is_finite(*claimed.point))
      details.surface = units(exact.off_surface(in_object(exact, *claimed.point), t));
    const auto off_exact = [&](const auto& number) {
      return off_point(ray, number, *claimed.point, precision);
    };
    if (!hits.empty()) details.forward = units(std::visit(off_exact, hits.front().t) / size);
  }
  if (const SurfaceParts parts = exact.parts(t); !parts.empty()) {
    const bool has_exact = hits.empty() || exact.normal(hits.front());
    if (!claimed.normal)
      details.normal = has_exact ? units(error_of_no_normal(exact, parts, t)) : 0;
    else
      details.normal =
          is_finite(*claimed.normal) ? units(error_of_normal(exact, parts, t, *claimed.normal)) : HUGE_VAL;
  }
  if (const auto weights = exact.barycentric())
    details.coordinates =
        claimed.barycentric ? units(error_of_coordinates(*weights, *claimed.barycentric)) : HUGE_VAL;
  else if (const auto parameters = exact.parameters(); claimed.parameters && parameters)
    details.coordinates = units(error_of_coordinates(*parameters, *claimed.parameters));
  if (details.coordinates) details.condition = value(exact.condition_of_coordinates());
  return details;
}

}  // namespace rayproof::oracle
