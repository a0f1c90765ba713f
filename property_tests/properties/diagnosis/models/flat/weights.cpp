#include "properties/diagnosis/models/flat/weights.hpp"

#include <algorithm>
#include <array>

#include "properties/diagnosis/models/flat/outline.hpp"

namespace rayproof::diagnosis {
namespace {

/// What the formula finds whose ray's way is taken from that point.
std::optional<TriangleHit> triangle_hit_from(const Case& one, const Triangle<double>& triangle,
                                             const glm::dvec3& start) {
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const glm::dvec3 b = triangle.b - triangle.a, c = triangle.c - triangle.a, way = ray.origin - start;
  const glm::dvec3 p = glm::cross(ray.direction, c), q = glm::cross(way, b), normal = glm::cross(b, c);
  const double size = glm::dot(b, p);
  if (size == 0) return std::nullopt;
  return TriangleHit{glm::dot(way, p) / size, glm::dot(ray.direction, q) / size, glm::dot(c, q) / size, size,
                     glm::dot(normal, normal)};
}

/// What may stand for u_i v_j - u_j v_i, i and j the two coordinates that follow the axis.
std::array<double, 6> wrong_coordinates(const glm::dvec3& u, const glm::dvec3& v, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  return {u[i] * v[j] + u[j] * v[i],    u[j] * v[i] - u[i] * v[j],    u[axis] * v[j] - u[j] * v[i],
          u[i] * v[axis] - u[j] * v[i], u[i] * v[j] - u[axis] * v[i], u[i] * v[j] - u[j] * v[axis]};
}

/// The cross product with its mistake of that number.
struct WrongCross {
  int axis;
  std::size_t mistake;
  [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& u, const glm::dvec3& v) const {
    glm::dvec3 product = glm::cross(u, v);
    product[axis] = wrong_coordinates(u, v, axis).at(mistake);
    return product;
  }
};

/// Möller and Trumbore's formula with such a cross product in the place of both its own, or of one.
template <bool is_p_wrong, bool is_q_wrong>
Answers by_moeller(const Case& one, const Triangle<double>& triangle, const WrongCross& cross) {
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const glm::dvec3 b = triangle.b - triangle.a, c = triangle.c - triangle.a, way = ray.origin - triangle.a;
  const glm::dvec3 p = is_p_wrong ? cross(ray.direction, c) : glm::cross(ray.direction, c);
  const glm::dvec3 q = is_q_wrong ? cross(way, b) : glm::cross(way, b);
  const double size = glm::dot(b, p);
  if (size == 0) return {RayAnswer{}};
  return by_weights(
      one, {glm::dot(way, p) / size, glm::dot(ray.direction, q) / size, glm::dot(c, q) / size, size, 0});
}

/// The plane's hit, and the sides looked at one after the other, with such a cross product.
Answers by_plane_and_sides(const Case& one, const Triangle<double>& triangle, const WrongCross& cross) {
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const std::array vertices{triangle.a, triangle.b, triangle.c};
  const glm::dvec3 normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  const double slope = glm::dot(normal, ray.direction);
  if (slope == 0) return {RayAnswer{}};
  const double t = glm::dot(normal, triangle.a - ray.origin) / slope;
  const glm::dvec3 point = point_at(ray, t);
  bool is_inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 side = vertices.at((i + 1) % 3) - vertices.at(i);
    is_inside = is_inside && glm::dot(normal, cross(side, point - vertices.at(i))) >= 0;
  }
  return hit_at(one, t, is_inside);
}

Answers planes_of_wrong_cross(const Case& one, const ParametricPlane& plane, int axis) {
  const Ray<double> ray = ray_in_object(*ray_question(one));
  Answers answers;
  for (std::size_t mistake = 0; mistake < 6; ++mistake) {
    const glm::dvec3 normal = WrongCross{axis, mistake}(plane.u, plane.v);
    const double slope = glm::dot(normal, ray.direction);
    const double t = glm::dot(normal, plane.point - ray.origin) / slope;
    answers.push_back(hit_at(one, t, slope != 0).front());
  }
  return answers;
}

/// A polygon's normal is a sum of cross products. Where one coordinate is that of wrong ones; and where it is
/// another one, as a wrong index makes it in the sum of (z_i - z_j)(x_i + x_j).
Answers polygons_of_wrong_sum(const Case& one, int axis) {
  const auto figure = flat_figure(one);
  Answers answers;
  if (!figure) return answers;
  const auto add = [&](double wrong) {
    FlatFigure mistaken = *figure;
    mistaken.normal[axis] = wrong;
    const auto hit = plane_hit(one, mistaken);
    answers.push_back(hit ? hit_at(one, hit->t, is_inside_outline(*hit)).front() : RayAnswer{});
  };
  const std::vector<glm::dvec3>& v = figure->vertices;
  for (std::size_t mistake = 0; mistake < 6; ++mistake) {
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i)
      sum += WrongCross{axis, mistake}(v[i], v[(i + 1) % v.size()])[axis];
    if (mistake != 1) add(sum);  // the opposite, a fault of its own
  }
  for (const int other : {(axis + 1) % 3, (axis + 2) % 3})
    for (const double sign : {1, -1}) add(sign * figure->normal[other]);
  return answers;
}

bool is_inside_along_normal(const FlatFigure& figure, const glm::dvec3& point) {
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &from = figure.vertices.at(i), &to = figure.vertices.at((i + 1) % 3);
    if (glm::dot(figure.normal, glm::cross(to - from, point - from)) < 0) return false;
  }
  return true;
}

}  // namespace

std::optional<TriangleHit> triangle_hit(const Case& one) {
  const auto* triangle = shape_in<Triangle<double>>(one);
  return triangle == nullptr ? std::nullopt : triangle_hit_from(one, *triangle, triangle->a);
}

Answers way_from_other_vertex(const Case& one, const Answer& /*exact*/) {
  const auto* triangle = shape_in<Triangle<double>>(one);
  Answers answers;
  if (triangle == nullptr) return answers;
  for (const glm::dvec3& start : {triangle->b, triangle->c})
    if (const auto hit = triangle_hit_from(one, *triangle, start))
      answers.push_back(by_weights(one, *hit).front());
  return answers;
}

Answers another_product(const Case& one, const Answer& /*exact*/) {
  using Number = double TriangleHit::*;
  static constexpr Number numbers[] = {&TriangleHit::beta, &TriangleHit::gamma, &TriangleHit::t};
  const auto hit = triangle_hit(one);
  Answers answers;
  if (!hit) return answers;
  for (const Number wrong : numbers) {
    TriangleHit mistaken = *hit;
    mistaken.*wrong = 0;
    answers.push_back(by_weights(one, mistaken).front());
    for (const Number other : numbers) {
      if (other == wrong) continue;
      mistaken.*wrong = (*hit).*other;
      answers.push_back(by_weights(one, mistaken).front());
    }
  }
  return answers;
}

Answers by_weights(const Case& one, const TriangleHit& hit) {
  Answers answers = hit_at(one, hit.t, hit.beta >= 0 && hit.gamma >= 0 && hit.beta + hit.gamma <= 1);
  auto& found = std::get<RayAnswer>(answers.front());
  if (found.hits.count > 0) found.barycentric = glm::dvec3(1 - hit.beta - hit.gamma, hit.beta, hit.gamma);
  return answers;
}

Answers beyond_edge(const Case& one, int vertex) {
  const auto hit = triangle_hit(one);
  if (!hit) return {};
  std::array<double, 3> weights{1 - hit->beta - hit->gamma, hit->beta, hit->gamma};
  weights.at(static_cast<std::size_t>(vertex)) *= -1;
  return hit_at(one, hit->t, std::ranges::min(weights) >= 0);
}

Answers by_wrong_cross(const Case& one, int axis) {
  if (const auto* plane = shape_in<ParametricPlane>(one)) return planes_of_wrong_cross(one, *plane, axis);
  if (shape_in<Polygon<double>>(one) != nullptr) return polygons_of_wrong_sum(one, axis);
  const auto* triangle = shape_in<Triangle<double>>(one);
  if (triangle == nullptr) return {};
  Answers answers;
  for (std::size_t mistake = 0; mistake < 6; ++mistake)
    for (const auto code :
         {by_moeller<true, true>, by_plane_and_sides, by_moeller<true, false>, by_moeller<false, true>})
      answers.push_back(code(one, *triangle, {axis, mistake}).front());
  return answers;
}

Answers where_inside(const Case& one, TestedPoint point) {
  const auto figure = flat_figure(one);
  auto hit = figure ? plane_hit(one, *figure) : std::nullopt;
  if (!hit) return {};
  const glm::dvec3 tested = point(ray_in_object(*ray_question(one)), hit->t, figure->normal);
  hit->point = projected(tested, hit->axis);
  Answers answers;
  if (shape_in<Triangle<double>>(one) != nullptr)
    answers = hit_at(one, hit->t, is_inside_along_normal(*figure, tested));
  answers.push_back(hit_at(one, hit->t, is_inside_outline(*hit)).front());
  return answers;
}

}  // namespace rayproof::diagnosis
