#include "properties/diagnosis/models/flat/flat.hpp"

#include <array>
#include <glm/common.hpp>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/examination/agreement.hpp"
#include "properties/diagnosis/models/hits/factor.hpp"
#include "properties/diagnosis/models/outlines/outline.hpp"
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

/// A plane whose distance from the origin of coordinates is `factor(length of its normal)` times as large.
template <class Factor>
std::vector<Case> with_distance(const Case& one, Factor&& factor) {
  return with_question(one, [&](RayQuestion& asked) {
    if (auto* plane = std::get_if<ImplicitPlane>(&asked.shape))
      plane->d *= factor(glm::length(plane->normal));
    else if (auto* with_normal = std::get_if<PointNormalPlane>(&asked.shape))
      with_normal->point *= factor(glm::length(with_normal->normal));
    else if (auto* parametric = std::get_if<ParametricPlane>(&asked.shape))
      parametric->point *= factor(glm::length(glm::cross(parametric->u, parametric->v)));
    else
      return false;
    return true;
  });
}

}  // namespace

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

glm::dvec3 point_of_plane(const Case& one) {
  if (const auto* p = shape_in<PointNormalPlane>(one)) return p->point;
  const auto* p = shape_in<ParametricPlane>(one);
  return p == nullptr ? glm::dvec3(0) : p->point;
}

std::optional<double> slope_of_surface(const Case& one) {
  const auto plane = implicit_form(one);
  const auto figure = flat_figure(one);
  if (!plane && !figure) return std::nullopt;
  const glm::dvec3 normal = plane ? plane->first : figure->normal;
  return glm::dot(normal, ray_in_object(*ray_question(one)).direction);
}

Answers misses_small_slope(const Case& one, const Answer& exact, double least) {
  const std::optional<double> slope = finds_something(exact) ? slope_of_surface(one) : std::nullopt;
  constexpr double rounding = 1 + 1e-4;  // of a slope that is the least
  return slope && std::abs(*slope) < least * rounding ? Answers{RayAnswer{}} : Answers{};
}

Answers slope_below_epsilon_missed(const Case& one, const Answer& exact) {
  return misses_small_slope(one, exact, one.precision == Precision::float32 ? 0x1p-23 : 0x1p-52);
}

Answers slope_below_float_epsilon_missed(const Case& one, const Answer& exact) {
  return misses_small_slope(one, exact, 0x1p-23);
}

Answers misses_grazing(const Case& one, const Answer& exact, double sine) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || !answer->normal || !lies_in_a_plane(one)) return {};
  const double along = glm::dot(*answer->normal, glm::normalize(ray_question(one)->ray.direction));
  return std::abs(along) < sine ? Answers{RayAnswer{}} : Answers{};
}

Answers culls_back(const Case& one, const Answer& exact) {
  return lies_in_a_plane(one) ? misses_side(one, exact, 1) : Answers{};
}
Answers culls_front(const Case& one, const Answer& exact) {
  return lies_in_a_plane(one) ? misses_side(one, exact, -1) : Answers{};
}
Answers misses_from_inside(const Case& one, const Answer& exact) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr || std::get<RayAnswer>(exact).hits.count == 0) return {};
  const HitList line = hits_of_line(one).hits;
  return line.count == 2 && line.t[0] < 0 && line.t[1] > 0 ? Answers{RayAnswer{}} : Answers{};
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
  return with_distance(one, [](double /*length*/) { return -1.0; });
}
std::vector<Case> without_constant(const Case& one) {
  return with_distance(one, [](double /*length*/) { return 0.0; });
}
std::vector<Case> constant_as_distance(const Case& one) {
  return with_distance(one, [](double length) { return length; });
}

std::vector<Case> plane_as_parallelogram(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    const auto* p = std::get_if<ParametricPlane>(&asked.shape);
    if (p == nullptr) return false;
    asked.shape = Polygon<double>{{p->point, p->point + p->u, p->point + p->u + p->v, p->point + p->v}};
    return true;
  });
}

Answers by_wrong_normal(const Case& one, int axis) {
  if (const auto* plane = shape_in<ParametricPlane>(one)) {
    PointNormalPlane other{plane->point, glm::cross(plane->u, plane->v)};
    other.normal[axis] *= -1;
    return exact_of(with_question(one, [&](RayQuestion& asked) {
      asked.shape = other;
      return true;
    }));
  }
  auto figure = flat_figure(one);
  if (!figure) return {};
  figure->normal[axis] *= -1;
  const auto hit = plane_hit(one, *figure);
  return hit ? hit_at(one, hit->t, is_inside_outline(*hit)) : Answers{RayAnswer{}};
}

Answers numerator_without_coefficients(const Case& one, const Answer& /*exact*/) {
  const auto plane = implicit_form(one);
  if (!plane) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const double slope = glm::dot(plane->first, ray.direction);
  const double t = -(ray.origin.x + ray.origin.y + ray.origin.z + plane->second) / slope;
  return slope == 0 ? Answers{} : hit_at(one, t, true);
}

Answers triangle_bounds(const Case& one, const Answer& /*exact*/) {
  const auto* triangle = shape_in<Triangle<double>>(one);
  const auto hit = plane_hit(one);
  if (triangle == nullptr || !hit) return {};
  const auto& [a, b, c] = *triangle;
  const glm::dvec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
  const glm::dvec3 point = point_at(ray_in_object(*ray_question(one)), hit->t);
  const glm::dvec3 slack = 0x1p-30 * (glm::abs(point) + (high - low));
  const auto is_in = [&](int i) { return low[i] - slack[i] <= point[i] && point[i] <= high[i] + slack[i]; };
  return hit_at(one, hit->t, is_in(0) && is_in(1) && is_in(2));
}

Answers flat_bounds_missed(const Case& one, const Answer& exact) {
  const auto figure = flat_figure(one);
  if (!figure || !finds_something(exact)) return {};
  glm::dvec3 low = figure->vertices.front(), high = low;
  for (const glm::dvec3& vertex : figure->vertices) {
    low = glm::min(low, vertex);
    high = glm::max(high, vertex);
  }
  return glm::any(glm::equal(low, high)) ? Answers{RayAnswer{}} : Answers{};
}

Answers upright_is_missed(const Case& one, const Answer& exact, int axis) {
  const auto figure = flat_figure(one);
  if (!figure || !finds_something(exact)) return {};
  const glm::dvec3& n = figure->normal;
  const bool is_upright = axis < 0 ? n.x * n.y * n.z == 0 : n[axis] == 0;
  return is_upright ? Answers{RayAnswer{}} : Answers{};
}

std::optional<bool> wrong_where_upright(const Case& one, const Answer& got, const Answer& exact) {
  const auto figure = flat_figure(one);
  if (!figure || shape_in<Polygon<double>>(one) == nullptr || agree(one, got, exact, Aspect::hits))
    return std::nullopt;
  const glm::dvec3& n = figure->normal;
  return n.x * n.y * n.z == 0;
}

Answers culls_by_first_corner(const Case& one, const Answer& exact) {
  const auto* polygon = shape_in<Polygon<double>>(one);
  if (polygon == nullptr || std::get<RayAnswer>(exact).hits.count == 0) return {};
  const double along =
      glm::dot(normal_of_corner(polygon->vertices), ray_in_object(*ray_question(one)).direction);
  return along >= 0 ? Answers{RayAnswer{}} : Answers{};
}

namespace {

/// Whether n·d may be 0 in rounded numbers, though it is not.
bool seems_parallel(const Case& one) {
  const auto along = slope(one), length = length_of_normal(one);
  const double digits = one.precision == Precision::float32 ? 0x1p-22 : 0x1p-51;
  return along && length &&
         std::abs(*along) <= digits * *length * glm::length(ray_in_object(*ray_question(one)).direction);
}

}  // namespace

std::optional<bool> parallel_is_hit(const Case& one, const Answer& got, const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr) return std::nullopt;
  const bool is_along = answer->contact == Contact::parallel || answer->contact == Contact::in_surface;
  if (!is_along) {
    const bool is_wrong =
        seems_parallel(one) && finds_something(got) && !agree(one, got, exact, Aspect::hits);
    return is_wrong ? std::optional(true) : std::nullopt;
  }
  if (std::get<RayAnswer>(got).hits.count > 0) return true;
  // It may say so at t = 0 alone, and where it finds n·d = 0 in rounded numbers.
  const bool may_miss = !in_interval(ray_question(one)->ray, 0.0) || slope(one).value_or(1) != 0;
  return may_miss ? std::nullopt : std::optional(false);
}

std::optional<bool> no_area_is_hit(const Case& /*one*/, const Answer& got, const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || answer->contact != Contact::degenerate) return std::nullopt;
  return finds_something(got) ? std::optional(true) : std::nullopt;
}

std::optional<bool> zero_slope_is_hit(const Case& one, const Answer& got, const Answer& exact) {
  const std::optional<bool> along = parallel_is_hit(one, got, exact);
  return along ? along : no_area_is_hit(one, got, exact);
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
