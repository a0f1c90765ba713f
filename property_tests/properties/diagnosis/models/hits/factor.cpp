#include "properties/diagnosis/models/hits/factor.hpp"

#include <algorithm>
#include <cmath>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/examination/agreement.hpp"
#include "properties/diagnosis/models/plane_hit.hpp"

namespace rayproof::diagnosis {
namespace {

/// `measure(question)` of a ray question.
template <class Measure>
std::optional<double> of_ray(const Case& one, Measure&& measure) {
  const RayQuestion* asked = ray_question(one);
  return asked == nullptr ? std::nullopt : std::optional<double>(measure(*asked));
}

double squared(const glm::dvec3& v) { return glm::dot(v, v); }

}  // namespace

Answers line_times(const Case& one, double factor) {
  const auto line = std::get<RayAnswer>(stretched(hits_of_line(one), factor));
  return {hits_where(line, [&](double t) { return in_interval(ray_question(one)->ray, t); })};
}

Answers times(const Case& one, const Answer& exact, double factor) {
  if (std::holds_alternative<Position>(exact)) return {};
  const RayQuestion* asked = ray_question(one);
  const auto* roots = std::get_if<QuadraticAnswer<double>>(&exact);
  if (roots != nullptr && roots->kind == RootKind::linear) return {};  // another formula's
  if (asked == nullptr && roots != nullptr && roots->kind == RootKind::twice)
    return {stretched(exact, factor), exact};  // which may be handled apart
  if (asked == nullptr) return {stretched(exact, factor)};
  Answers answers = line_times(one, factor);
  answers.push_back(stretched(exact, factor));  // where t is compared with the interval before that
  if (!finds_something(exact)) return answers;
  RayAnswer in_order = std::get<RayAnswer>(exact);  // nor are they sorted anew where the factor is negative
  for (std::size_t i = 0; i < in_order.hits.count; ++i) in_order.hits.t.at(i) *= factor;
  if (factor < 0) answers.push_back(in_order);
  return answers;
}

Answers absolute(const Case& one, const Answer& exact) {
  const RayQuestion* asked = ray_question(one);
  if (const auto* roots = std::get_if<QuadraticAnswer<double>>(&exact); roots != nullptr) {
    QuadraticAnswer<double> positive = *roots;
    for (double& x : positive.roots) x = std::abs(x);
    QuadraticAnswer<double> in_order = positive;
    std::sort(in_order.roots.begin(), in_order.roots.begin() + static_cast<std::ptrdiff_t>(in_order.count));
    if (roots->count == 1) return {positive, exact};  // it may look at two roots alone
    return {in_order, positive};
  }
  if (asked == nullptr) return {};
  RayAnswer line = hits_of_line(one);
  for (double& t : line.hits.t) t = std::abs(t);
  std::sort(line.hits.t.begin(), line.hits.t.begin() + static_cast<std::ptrdiff_t>(line.hits.count));
  const auto admitted = [&] {
    return Answer{hits_where(line, [&](double t) { return in_interval(asked->ray, t); })};
  };
  Answers answers{admitted()};
  if (line.hits.count < 2 || !are_close(one.precision, line.hits.t[0], line.hits.t[1], 0)) return answers;
  line.hits.count = 1;  // equal ones may be given once
  answers.push_back(admitted());
  return answers;
}

Answers reciprocal(const Case& one, const Answer& /*exact*/) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return {};
  const RayAnswer line = hits_of_line(one);
  return line.hits.count == 1 ? hit_at(one, 1 / line.hits.t[0], true) : Answers{};
}

Answers made_whole(const Case& one, const Answer& exact, double (*whole)(double)) {
  if (std::holds_alternative<Position>(exact)) return {};
  Answer changed = exact;
  if (auto* roots = std::get_if<QuadraticAnswer<double>>(&changed)) {
    for (double& x : roots->roots) x = whole(x);
    Answer once = changed;  // equal ones may be given once
    if (roots->count == 2 && roots->roots[0] == roots->roots[1])
      std::get<QuadraticAnswer<double>>(once).count = 1;
    if (roots->count == 1) once = exact;  // it may do so with two roots alone
    return {changed, once};
  }
  for (double& t : std::get<RayAnswer>(changed).hits.t) t = whole(t);
  RayAnswer line = hits_of_line(one);  // where t is compared with the interval after that
  for (double& t : line.hits.t) t = whole(t);
  return {hits_where(line, [&](double t) { return in_interval(ray_question(one)->ray, t); }), changed};
}

std::optional<double> minus_one(const Case& /*one*/) { return -1; }
std::optional<double> two(const Case& /*one*/) { return 2; }

std::optional<double> length_of_direction(const Case& one) {
  return of_ray(one, [](const RayQuestion& asked) { return glm::length(asked.ray.direction); });
}

std::optional<double> square_of_direction(const Case& one) {
  return of_ray(one, [](const RayQuestion& asked) { return squared(asked.ray.direction); });
}

std::optional<double> length_in_object(const Case& one) {
  return of_ray(one, [](const RayQuestion& asked) { return glm::length(ray_in_object(asked).direction); });
}

std::optional<double> stretch_of_direction(const Case& one) {
  const auto in_object = length_in_object(one), in_world = length_of_direction(one);
  return in_object && in_world ? std::optional(*in_object / *in_world) : std::nullopt;
}

std::optional<double> constant_of_sphere(const Case& one) {
  const auto* sphere = shape_in<Sphere<double>>(one);
  if (sphere == nullptr) return std::nullopt;
  const glm::dvec3 origin = ray_in_object(*ray_question(one)).origin;
  return squared(origin - sphere->center) - sphere->radius * sphere->radius;
}

std::optional<double> radius_of_sphere(const Case& one) {
  const auto* sphere = shape_in<Sphere<double>>(one);
  return sphere == nullptr ? std::nullopt : std::optional(sphere->radius);
}

std::optional<double> coefficient_a(const Case& one) {
  const auto* equation = std::get_if<Quadratic<double>>(&one.question);
  return equation == nullptr || equation->a == 0 ? std::nullopt : std::optional(equation->a);
}

std::optional<double> square_of_a(const Case& one) {
  const auto a = coefficient_a(one);
  return a ? std::optional(*a * *a) : std::nullopt;
}

std::optional<double> coefficient_c(const Case& one) {
  const auto* equation = std::get_if<Quadratic<double>>(&one.question);
  return equation == nullptr ? std::nullopt : std::optional(equation->c);
}

namespace {

/// The normal of a plane or a triangle, of any length.
std::optional<glm::dvec3> some_normal(const Case& one) {
  if (const auto* plane = shape_in<ImplicitPlane>(one)) return plane->normal;
  if (const auto* plane = shape_in<PointNormalPlane>(one)) return plane->normal;
  if (const auto* plane = shape_in<ParametricPlane>(one)) return glm::cross(plane->u, plane->v);
  if (const auto* t = shape_in<Triangle<double>>(one)) return glm::cross(t->b - t->a, t->c - t->a);
  return std::nullopt;
}

}  // namespace

std::optional<double> length_of_normal(const Case& one) {
  const auto normal = some_normal(one);
  return normal ? std::optional(glm::length(*normal)) : std::nullopt;
}

std::optional<double> slope(const Case& one) {
  const auto normal = some_normal(one);
  return normal ? std::optional(glm::dot(*normal, ray_in_object(*ray_question(one)).direction))
                : std::nullopt;
}

std::optional<double> distance_per_t(const Case& one) {
  const auto along = slope(one), length = length_of_normal(one);
  return along && length ? std::optional(std::abs(*along) / *length) : std::nullopt;
}

std::optional<double> sign_of_slope(const Case& one) {
  const auto along = slope(one);
  return along ? std::optional(*along < 0 ? -1.0 : 1.0) : std::nullopt;
}

std::optional<double> minus_sign_of_slope(const Case& one) {
  const auto sign = sign_of_slope(one);
  return sign ? std::optional(-*sign) : std::nullopt;
}

std::optional<double> minus_slope(const Case& one) {
  const auto along = slope(one);
  return along ? std::optional(-*along) : std::nullopt;
}

}  // namespace rayproof::diagnosis
