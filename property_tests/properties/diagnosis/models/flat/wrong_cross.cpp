#include "properties/diagnosis/models/flat/wrong_cross.hpp"

#include <array>

#include "properties/diagnosis/models/flat/weights.hpp"
#include "properties/diagnosis/models/outlines/outline.hpp"

namespace rayproof::diagnosis {
namespace {

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

/// The coordinate of a polygon's normal that is a sum of such coordinates of cross products of the vertices,
/// as they are seen from a point.
double sum_of_wrong_crosses(const std::vector<glm::dvec3>& vertices, const glm::dvec3& from,
                            const WrongCross& cross) {
  double sum = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    sum += cross(vertices[i] - from, vertices[(i + 1) % vertices.size()] - from)[cross.axis];
  return sum;
}

/// A polygon's normal with one coordinate that is such a sum, or another coordinate, as a wrong index makes
/// it in the sum of (z_i - z_j)(x_i + x_j).
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
  for (const glm::dvec3& from : {glm::dvec3(0), figure->vertices.front()})
    for (const std::size_t mistake :
         {0UL, 2UL, 3UL, 4UL, 5UL})  // that of number 1 is the opposite, a fault of its own
      add(sum_of_wrong_crosses(figure->vertices, from, {axis, mistake}));
  for (const int other : {(axis + 1) % 3, (axis + 2) % 3})
    for (const double sign : {1, -1}) add(sign * figure->normal[other]);
  return answers;
}

}  // namespace

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

}  // namespace rayproof::diagnosis
