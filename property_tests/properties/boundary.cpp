#include "properties/boundary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <optional>

#include "oracle/oracle.hpp"
#include "properties/trial.hpp"

namespace rayproof {
namespace {

using enum BoundaryPlace;

/// Of whole numbers, in object space: what is not equal differs by far more.
bool is_same(double x, double y) {
  return std::abs(x - y) <= 0x1p-20 * std::max(std::abs(x), std::abs(y)) + 0x1p-60;
}

BoundaryPlaces only(BoundaryPlace place) {
  BoundaryPlaces places;
  places.set(static_cast<std::size_t>(place));
  return places;
}

/// The edge of a triangle that a point of these barycentric coordinates lies on.
BoundaryPlaces edge_of(const glm::dvec3& weights, bool is_behind) {
  using Edges = std::array<BoundaryPlace, 3>;
  const Edges edges =
      is_behind ? Edges{edge_a_behind, edge_b_behind, edge_c_behind} : Edges{edge_a, edge_b, edge_c};
  BoundaryPlaces places;
  for (int i = 0; i < 3; ++i)
    if (weights[i] == 0) places |= only(edges.at(static_cast<std::size_t>(i)));
  return places.count() > 1 ? only(vertex) : places;
}

/// The faces of the unit cube, at 0 or at 1, in which the line runs.
BoundaryPlaces faces_of(const glm::dvec3& origin, const glm::dvec3& direction) {
  BoundaryPlaces places;
  for (int axis = 0; axis < 3; ++axis) {
    if (!is_same(direction[axis] + 1, 1)) continue;
    if (is_same(origin[axis] + 1, 1)) places |= only(low_face);
    if (is_same(origin[axis], 1)) places |= only(high_face);
  }
  return places.any() ? places : only(edge);
}

/// Whether a point is at the end of a polygon, in x or y.
BoundaryPlaces ends_of(const PointAndPolygon<double>& asked) {
  BoundaryPlaces places;
  for (const auto coordinate : {&Vec2<double>::x, &Vec2<double>::y}) {
    const auto [low, high] = std::ranges::minmax(asked.vertices, {}, coordinate);
    if (asked.point.*coordinate == high.*coordinate) places |= only(greatest);
    if (asked.point.*coordinate == low.*coordinate) places |= only(least);
  }
  return places;
}

/// Whether the point lies on the side ab, in numbers so short that nothing is rounded.
bool is_on_side(const Vec2<double>& point, const Vec2<double>& a, const Vec2<double>& b) {
  const auto is_between = [](double x, double from, double to) {
    return std::min(from, to) <= x && x <= std::max(from, to);
  };
  return is_between(point.x, a.x, b.x) && is_between(point.y, a.y, b.y) &&
         (b.x - a.x) * (point.y - a.y) == (b.y - a.y) * (point.x - a.x);
}

/// Where on its boundary a point of a polygon is; on the closing side, where it lies on no other one.
BoundaryPlace place_on(const PointAndPolygon<double>& asked) {
  const auto& [point, vertices] = asked;
  std::optional<BoundaryPlace> place;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const bool is_closing = i + 1 == vertices.size();
    const auto &a = vertices[i], &b = vertices[is_closing ? 0 : i + 1];
    if (a.x == point.x && a.y == point.y) return vertex;
    if (!is_on_side(point, a, b) || (is_closing && place)) continue;
    place = is_closing ? closing_side : a.y == b.y ? level_side : a.x == b.x ? upright_side : edge;
  }
  return place.value_or(edge);
}

BoundaryPlaces places_on(const PointAndPolygon<double>& asked) {
  return only(place_on(asked)) | ends_of(asked);
}

/// Which edge, of a case that lies on one.
struct EdgeOf {
  const Ray<double>& ray;  ///< in object space
  const RayAnswer& exact;

  template <class S>
  BoundaryPlaces operator()(const S& /*shape*/) const {
    return only(edge);
  }
  BoundaryPlaces operator()(const Triangle<double>& triangle) const {
    return exact.barycentric ? edge_of(*exact.barycentric, is_behind(triangle, ray)) : only(edge);
  }
  BoundaryPlaces operator()(const Box<double>& box) const {
    const glm::dvec3 size = glm::max(box.max - box.min, glm::dvec3(0x1p-1000));
    return faces_of((ray.origin - box.min) / size, ray.direction / glm::length(ray.direction));
  }
  BoundaryPlaces operator()(const Parallelepiped<double>& solid) const {
    const glm::dmat3 inverse = glm::inverse(glm::dmat3(solid.edges[0], solid.edges[1], solid.edges[2]));
    return faces_of(inverse * (ray.origin - solid.corner),
                    inverse * ray.direction / glm::length(inverse * ray.direction));
  }
  BoundaryPlaces operator()(const Cylinder<double>& cylinder) const {
    const bool is_along_axis = ray.direction.x == 0 && ray.direction.y == 0;
    if (cylinder.capped) return only(is_along_axis ? along_side : edge);
    BoundaryPlaces places;
    for (const double t : exact.hits.view()) {
      const double z = ray.origin.z + t * ray.direction.z;
      const bool is_level = is_same(ray.direction.z / glm::length(ray.direction) + 1, 1);
      if (is_same(z + cylinder.height, cylinder.height)) places |= only(is_level ? level_rim : low_rim);
      if (is_same(z, cylinder.height)) places |= only(is_level ? level_rim : high_rim);
    }
    return places;
  }
};

/// Hits are on a boundary that belongs to the shape; a change of verdict is then at no distance. What runs
/// inside a surface has no first hit.
BoundaryPlaces places_of(const Case& one, const RayQuestion& asked, RayAnswer exact, bool is_first_alone) {
  BoundaryPlaces places;
  if (exact.hits.count == 0) return exact.contact == Contact::in_surface ? only(in_surface) : places;
  const bool is_inside_of_face = exact.contact == Contact::crossing;
  const BoundaryPlace origin = enters_at_origin(exact)                               ? entering
                               : is_inside_of_face && leaves_at_origin(asked, exact) ? leaving
                                                                                     : at_origin;
  if (is_first_alone) exact.hits.count = 1;
  for (const double t : exact.hits.view()) {
    if (t == asked.ray.t_min) places |= only(t == 0 ? origin : t_min);
    if (t == asked.ray.t_max) places |= only(t_max);
  }
  const auto* sphere = std::get_if<Sphere<double>>(&asked.shape);
  if (sphere != nullptr && sphere->radius == 0) return places | only(no_radius);
  const Ray<double> ray = ray_in_object(asked);
  if (exact.contact == Contact::tangent)
    return places | only(runs_along_axis(ray) ? tangent_along_axis : tangent);
  const auto edges = [&] { return std::visit(EdgeOf{ray, exact}, asked.shape); };
  if (const auto* cylinder = std::get_if<Cylinder<double>>(&asked.shape); cylinder && !cylinder->capped)
    return places | edges();
  if (places.any()) return exact.contact == Contact::crossing ? places : places | edges();
  return oracle::judge(one, RayAnswer{}).margin == 0 ? edges() : places;
}

}  // namespace

bool runs_along_axis(const Ray<double>& ray) {
  const glm::dvec3& d = ray.direction;
  return int{d.x != 0} + int{d.y != 0} + int{d.z != 0} == 1;
}

bool is_behind(const Triangle<double>& triangle, const Ray<double>& ray) {
  return glm::dot(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a), ray.direction) > 0;
}

bool enters_at_origin(const RayAnswer& exact) { return exact.hits.count > 1 && exact.hits.t[0] == 0; }

bool leaves_at_origin(const RayQuestion& asked, const RayAnswer& exact) {
  const auto* cylinder = std::get_if<Cylinder<double>>(&asked.shape);
  const bool is_solid = std::holds_alternative<Sphere<double>>(asked.shape) ||
                        std::holds_alternative<Box<double>>(asked.shape) ||
                        std::holds_alternative<Parallelepiped<double>>(asked.shape) ||
                        (cylinder != nullptr && cylinder->capped);
  return is_solid && exact.hits.count == 1 && exact.hits.t[0] == 0 && asked.ray.t_max == infinity<double>;
}

BoundaryPlaces boundary_places(const Case& one, bool is_first_alone) {
  const Answer exact = oracle::answer(one);
  if (const auto* position = std::get_if<Position>(&exact))
    return *position == Position::boundary ? places_on(std::get<PointAndPolygon<double>>(one.question))
                                           : BoundaryPlaces{};
  if (const auto* roots = std::get_if<QuadraticAnswer<double>>(&exact))
    return roots->kind == RootKind::twice ? only(tangent) : BoundaryPlaces{};
  return places_of(one, std::get<RayQuestion>(one.question), std::get<RayAnswer>(exact), is_first_alone);
}

bool is_exact_for_some_method(const Case& one) {
  return std::ranges::any_of(subjects(), [&](const Subject& subject) {
    return subject.topic == topic_of(one) && subject.is_exact_on != nullptr &&
           subject.contract.holds.contains(Claim::exact) && subject.is_exact_on(one);
  });
}

}  // namespace rayproof
