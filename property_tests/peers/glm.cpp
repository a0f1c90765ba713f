/// \file
/// GLM 0.9.9, gtx/intersect, in float and double. Its documentation asks for unit directions, and for a unit
/// normal of a plane; it says nothing of scale, of hits at the origin, or of rays that begin inside.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "peers/reproduction.hpp"
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>

namespace rayproof {
namespace {

using peers::given;

/// What stands before every call.
constexpr const char* headers = R"(#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtx/intersect.hpp>
using vec3 = glm::vec<3, $T>;
)";

template <class T>
bool plane(vec3<T> origin, vec3<T> direction, vec3<T> point, vec3<T> normal, T& t) {
  normal = glm::normalize(normal);
  peers::LibraryCall call("glm::intersectRayPlane", headers);
  call.add(R"($T t = 0;
bool hit = glm::intersectRayPlane(vec3($origin), vec3($direction), vec3($point), vec3($normal), t);
std::printf("hit = %d, t = $g\n", hit, t);)",
           given("origin", origin), given("direction", direction), given("point", point),
           given("normal", normal));
  call.ask();
  const bool is_hit = glm::intersectRayPlane(origin, direction, point, normal, t = 0);
  call.said(given("hit", is_hit), given("t", t));
  return is_hit;
}

template <class T>
bool triangle(vec3<T> origin, vec3<T> direction, vec3<T> a, vec3<T> b, vec3<T> c, T& t, T& u, T& v) {
  peers::LibraryCall call("glm::intersectRayTriangle", headers);
  call.add(R"($T t = 0;
glm::vec<2, $T> uv(0);
bool hit = glm::intersectRayTriangle(vec3($origin), vec3($direction), vec3($a), vec3($b), vec3($c), uv, t);
std::printf("hit = %d, t = $g, u = $g, v = $g\n", hit, t, uv.x, uv.y);)",
           given("origin", origin), given("direction", direction), given("a", a), given("b", b),
           given("c", c));
  call.ask();
  glm::vec<2, T> coordinates{};
  const bool is_hit = glm::intersectRayTriangle(origin, direction, a, b, c, coordinates, t = 0);
  u = coordinates.x;
  v = coordinates.y;
  call.said(given("hit", is_hit), given("t", t), given("u", u), given("v", v));
  return is_hit;
}

template <class T>
bool sphere(vec3<T> origin, vec3<T> direction, vec3<T> center, T radius, T& t) {
  const T radius2 = radius * radius;
  peers::LibraryCall call("glm::intersectRaySphere", headers);
  call.add(R"($T t = 0;
bool hit = glm::intersectRaySphere(vec3($origin), vec3($direction), vec3($center), $radius2, t);
std::printf("hit = %d, t = $g\n", hit, t);)",
           given("origin", origin), given("direction", direction), given("center", center),
           given("radius2", radius2));
  call.ask();
  const bool is_hit = glm::intersectRaySphere(origin, direction, center, radius2, t = 0);
  call.said(given("hit", is_hit), given("t", t));
  return is_hit;
}

/// The overload that gives point and normal; its point is not asked for t.
template <class T>
bool sphere_details(vec3<T> origin, vec3<T> direction, vec3<T> center, T radius, vec3<T>& point,
                    vec3<T>& normal) {
  if (radius == T(0)) throw Unsupported();  // a point has no normal
  peers::LibraryCall call("glm::intersectRaySphere", headers);
  call.add(R"(vec3 point(0), normal(0);
bool hit = glm::intersectRaySphere(vec3($origin), vec3($direction), vec3($center), $T($radius), point, normal);
std::printf("hit = %d, x = $g, y = $g, z = $g\n", hit, point.x, point.y, point.z);)",
           given("origin", origin), given("direction", direction), given("center", center),
           given("radius", radius));
  call.ask();
  point = vec3<T>(0);
  const bool is_hit = glm::intersectRaySphere(origin, direction, center, radius, point, normal);
  call.said(given("hit", is_hit), given("x", point.x), given("y", point.y), given("z", point.z));
  return is_hit;
}

/// The versions for lines: all t count.
template <class T>
bool line_triangle(vec3<T> origin, vec3<T> direction, vec3<T> a, vec3<T> b, vec3<T> c, T& t, T& u, T& v) {
  peers::LibraryCall call("glm::intersectLineTriangle", headers, given("t_min", -infinity<T>));
  call.add(R"(vec3 tuv(0);
bool hit = glm::intersectLineTriangle(vec3($origin), vec3($direction), vec3($a), vec3($b), vec3($c), tuv);
std::printf("hit = %d, t = $g, u = $g, v = $g\n", hit, tuv.x, tuv.y, tuv.z);)",
           given("origin", origin), given("direction", direction), given("a", a), given("b", b),
           given("c", c));
  call.ask();
  vec3<T> position{};  // t, u, v, as its code has it
  const bool is_hit = glm::intersectLineTriangle(origin, direction, a, b, c, position);
  t = position.x;
  u = position.y;
  v = position.z;
  call.said(given("hit", is_hit), given("t", t), given("u", u), given("v", v));
  return is_hit;
}

template <class T>
bool line_sphere(vec3<T> origin, vec3<T> direction, vec3<T> center, T radius, T& t0, T& t1) {
  vec3<T> point0{}, point1{}, normal0{}, normal1{};
  // Two points of the line, as far apart as they are from the sphere, so that rounding turns it by little.
  const T distance = glm::length(origin) + glm::length(center - origin) + radius;
  const T factor = std::exp2(std::ceil(std::log2(std::max(T(1), distance / glm::length(direction)))));
  const vec3<T> end = origin + factor * direction;
  peers::LibraryCall call("glm::intersectLineSphere", headers, given("t_min", -infinity<T>),
                          given("t_max", infinity<T>));
  call.add(R"(vec3 p, n, q, m;
bool hit = glm::intersectLineSphere(vec3($start), vec3($end), vec3($center), $T($radius), p, n, q, m);
std::printf("hit = %d, x = $g, y = $g, z = $g\n", hit, hit * p.x, hit * p.y, hit * p.z);)",
           given("start", origin), given("end", end), given("center", center), given("radius", radius));
  call.ask();
  const bool is_hit = glm::intersectLineSphere(origin, end, center, radius, point0, normal0, point1, normal1);
  const T length2 = dot(direction, direction);
  t0 = dot(point0 - origin, direction) / length2;
  t1 = dot(point1 - origin, direction) / length2;
  const vec3<T> first = is_hit ? point0 : vec3<T>(0);
  call.said(given("hit", is_hit), given("x", first.x), given("y", first.y), given("z", first.z));
  if (t1 < t0) std::swap(t0, t1);  // it promises no order
  return is_hit;
}

peers::Library glm_library() {
  return {"GLM",
          std::to_string(GLM_VERSION_MAJOR) + "." + std::to_string(GLM_VERSION_MINOR) + "." +
              std::to_string(GLM_VERSION_PATCH) + "." + std::to_string(GLM_VERSION_REVISION),
          peers::built_with(""), "https://github.com/g-truc/glm/issues"};
}

}  // namespace
}  // namespace rayproof

int main(int count, char** arguments) {
  using namespace rayproof;
  peers::introduce(count, arguments, glm_library());
  const std::string_view which = count > 1 ? arguments[1] : "";
  if (which == "details") return answer_cases(sphere_details<float>, sphere_details<double>, unit_direction);
  if (which == "line")
    return answer_cases(line_triangle<float>, line_triangle<double>, line_sphere<float>, line_sphere<double>,
                        whole_line);
  return answer_cases(takes<PointNormalPlane>(plane<float>), takes<PointNormalPlane>(plane<double>),
                      triangle<float>, triangle<double>, sphere<float>, sphere<double>, unit_direction);
}
