#include "properties/diagnosis/models/flat.hpp"

#include <array>

#include "properties/diagnosis/models/plane_hit.hpp"

namespace rayproof::diagnosis {
namespace {

/// A miss where the first hit is on that side of the surface: 1 for a ray that runs along the normal.
Answers misses_side(const Case& one, const Answer& exact, double side) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || !answer->normal) return {};
  const double along = side * glm::dot(*answer->normal, ray_question(one)->ray.direction);
  return along > 0 ? Answers{RayAnswer{}} : Answers{};
}

bool is_flat(const Case& one) {
  return shape_in<ImplicitPlane>(one) != nullptr || shape_in<PointNormalPlane>(one) != nullptr ||
         shape_in<ParametricPlane>(one) != nullptr || flat_figure(one).has_value();
}

template <class DoChange>
std::vector<Case> with_implicit(const Case& one, DoChange&& change) {
  return with_shape<ImplicitPlane>(one, [&](RayQuestion& /*asked*/, ImplicitPlane& plane) {
    change(plane);
    return true;
  });
}

/// normal and d of any form of a plane.
std::optional<std::pair<glm::dvec3, double>> implicit_form(const Case& one) {
  if (const auto* p = shape_in<ImplicitPlane>(one)) return std::pair{p->normal, p->d};
  if (const auto* p = shape_in<PointNormalPlane>(one))
    return std::pair{p->normal, -glm::dot(p->normal, p->point)};
  if (const auto* p = shape_in<ParametricPlane>(one)) {
    const glm::dvec3 normal = glm::cross(p->u, p->v);
    return std::pair{normal, -glm::dot(normal, p->point)};
  }
  return std::nullopt;
}

}  // namespace

Answers culls_back(const Case& one, const Answer& exact) {
  return is_flat(one) ? misses_side(one, exact, 1) : Answers{};
}
Answers culls_front(const Case& one, const Answer& exact) {
  return is_flat(one) ? misses_side(one, exact, -1) : Answers{};
}
Answers misses_from_inside(const Case& one, const Answer& exact) {
  return is_flat(one) ? Answers{} : misses_side(one, exact, 1);
}

std::vector<Case> as_plane(const Case& one) {
  const auto figure = flat_figure(one);
  if (!figure) return {};
  return with_question(one, [&](RayQuestion& asked) {
    asked.shape = PointNormalPlane{figure->vertices.front(), figure->normal};
    return true;
  });
}

std::vector<Case> as_parallelogram(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    const auto* t = std::get_if<Triangle<double>>(&asked.shape);
    if (t == nullptr) return false;
    asked.shape = Polygon<double>{{t->a, t->b, t->b + t->c - t->a, t->c}};
    return true;
  });
}

std::vector<Case> constant_negated(const Case& one) {
  return with_implicit(one, [](ImplicitPlane& plane) { plane.d = -plane.d; });
}
std::vector<Case> without_constant(const Case& one) {
  return with_implicit(one, [](ImplicitPlane& plane) { plane.d = 0; });
}
std::vector<Case> constant_as_distance(const Case& one) {
  return with_implicit(one, [](ImplicitPlane& plane) { plane.d *= glm::length(plane.normal); });
}

std::vector<Case> plane_through_zero(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    if (auto* plane = std::get_if<PointNormalPlane>(&asked.shape)) plane->point = glm::dvec3(0);
    if (auto* plane = std::get_if<ParametricPlane>(&asked.shape)) plane->point = glm::dvec3(0);
    return true;
  });
}

std::vector<Case> plane_as_parallelogram(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    const auto* p = std::get_if<ParametricPlane>(&asked.shape);
    if (p == nullptr) return false;
    asked.shape = Polygon<double>{{p->point, p->point + p->u, p->point + p->u + p->v, p->point + p->v}};
    return true;
  });
}

Answers numerator_without_coefficients(const Case& one, const Answer& /*exact*/) {
  const auto plane = implicit_form(one);
  if (!plane) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const double slope = glm::dot(plane->first, ray.direction);
  const double t = -(ray.origin.x + ray.origin.y + ray.origin.z + plane->second) / slope;
  return slope == 0 ? Answers{} : hit_at(one, t, true);
}

template <int term>
Answers wrong_sign(const Case& one, const Answer& /*exact*/) {
  const auto hit = plane_hit(one);
  if (!hit || hit->vertices.size() != 3) return {};
  const glm::dvec2 a = hit->vertices[0], b = hit->vertices[1], c = hit->vertices[2], q = hit->point - c;
  std::array<double, 4> terms{(b.y - c.y) * q.x, -(b.x - c.x) * q.y, -(a.y - c.y) * q.x, (a.x - c.x) * q.y};
  terms.at(term) = -terms.at(term);
  const double area = (b.y - c.y) * (a.x - c.x) - (b.x - c.x) * (a.y - c.y);
  const double first = (terms[0] + terms[1]) / area, second = (terms[2] + terms[3]) / area;
  return hit_at(one, hit->t, first >= 0 && second >= 0 && first + second <= 1);
}

template Answers wrong_sign<0>(const Case&, const Answer&);
template Answers wrong_sign<1>(const Case&, const Answer&);
template Answers wrong_sign<2>(const Case&, const Answer&);
template Answers wrong_sign<3>(const Case&, const Answer&);

}  // namespace rayproof::diagnosis
