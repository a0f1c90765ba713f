/// \file
/// GLM 0.9.9, gtx/intersect, in float and double. Its documentation asks for unit directions, and for a unit
/// normal of a plane; it says nothing of scale, of hits at the origin, or of rays that begin inside.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "answer_cases.hpp"
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>

namespace rayproof {
namespace {

template <class T>
bool plane(vec3<T> origin, vec3<T> direction, vec3<T> point, vec3<T> normal, T& t) {
  return glm::intersectRayPlane(origin, direction, point, glm::normalize(normal), t);
}

template <class T>
bool triangle(vec3<T> origin, vec3<T> direction, vec3<T> a, vec3<T> b, vec3<T> c, T& t, T& u, T& v) {
  glm::vec<2, T> coordinates{};
  const bool is_hit = glm::intersectRayTriangle(origin, direction, a, b, c, coordinates, t);
  u = coordinates.x;
  v = coordinates.y;
  return is_hit;
}

template <class T>
bool sphere(vec3<T> origin, vec3<T> direction, vec3<T> center, T radius, T& t) {
  return glm::intersectRaySphere(origin, direction, center, radius * radius, t);
}

/// The overload that gives point and normal; its point is not asked for t.
template <class T>
bool sphere_details(vec3<T> origin, vec3<T> direction, vec3<T> center, T radius, vec3<T>& point,
                    vec3<T>& normal) {
  if (radius == T(0)) throw Unsupported();  // a point has no normal
  return glm::intersectRaySphere(origin, direction, center, radius, point, normal);
}

/// The versions for lines: all t count.
template <class T>
bool line_triangle(vec3<T> origin, vec3<T> direction, vec3<T> a, vec3<T> b, vec3<T> c, T& t, T& u, T& v) {
  vec3<T> position{};  // t, u, v, as its code has it
  const bool is_hit = glm::intersectLineTriangle(origin, direction, a, b, c, position);
  t = position.x;
  u = position.y;
  v = position.z;
  return is_hit;
}

template <class T>
bool line_sphere(vec3<T> origin, vec3<T> direction, vec3<T> center, T radius, T& t0, T& t1) {
  vec3<T> point0{}, point1{}, normal0{}, normal1{};
  // Two points of the line, as far apart as they are from the sphere, so that rounding turns it by little.
  const T distance = glm::length(origin) + glm::length(center - origin) + radius;
  const T factor = std::exp2(std::ceil(std::log2(std::max(T(1), distance / glm::length(direction)))));
  const bool is_hit = glm::intersectLineSphere(origin, vec3<T>(origin + factor * direction), center, radius,
                                               point0, normal0, point1, normal1);
  const T length2 = dot(direction, direction);
  t0 = dot(point0 - origin, direction) / length2;
  t1 = dot(point1 - origin, direction) / length2;
  if (t1 < t0) std::swap(t0, t1);  // it promises no order
  return is_hit;
}

}  // namespace
}  // namespace rayproof

int main(int count, char** arguments) {
  using namespace rayproof;
  const std::string_view which = count > 1 ? arguments[1] : "";
  if (which == "details") return answer_cases(sphere_details<float>, sphere_details<double>, unit_direction);
  if (which == "line")
    return answer_cases(line_triangle<float>, line_triangle<double>, line_sphere<float>, line_sphere<double>,
                        whole_line);
  return answer_cases(takes<PointNormalPlane>(plane<float>), takes<PointNormalPlane>(plane<double>),
                      triangle<float>, triangle<double>, sphere<float>, sphere<double>, unit_direction);
}
