/// \file
/// CGAL 5.5 with exact predicates and inexact constructions, in double: CGAL::intersection of a ray (a line
/// where t_min is -inf) with a triangle, plane and box, and `tree`, an AABB tree around one triangle. Its
/// manual promises that what is decided is exact and what is constructed is rounded; objects must not be
/// degenerate. t is read off the point along the direction's largest component.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <list>
#include <string_view>

#include "peers/reproduction.hpp"

namespace rayproof {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using glm::dvec3;

Point at(const dvec3& p) { return {p.x, p.y, p.z}; }

/// The ray's direction, so long that the second point of CGAL's ray, origin + direction, turns it by little.
Kernel::Vector_3 along(const Ray<double>& ray) {
  const double ratio = glm::length(ray.origin) / glm::length(ray.direction);
  const dvec3 v = std::exp2(std::ceil(std::log2(std::max(1.0, ratio)))) * ray.direction;
  return {v.x, v.y, v.z};
}

/// The t of a point on the ray's line.
double t_of(const Ray<double>& ray, const Point& point) {
  int axis = 0;
  for (const int other : {1, 2})
    if (std::abs(ray.direction[other]) > std::abs(ray.direction[axis])) axis = other;
  return (point[axis] - ray.origin[axis]) / ray.direction[axis];
}

/// The t of what two objects have in common: a point, or the ends of a segment; a whole ray has none.
template <class Found>
std::vector<double> t_of_all(const Ray<double>& ray, const Found& found) {
  std::vector<double> hits;
  if (!found) return hits;
  if (const auto* point = boost::relaxed_get<Point>(&*found)) hits = {t_of(ray, *point)};
  if (const auto* segment = boost::relaxed_get<Kernel::Segment_3>(&*found)) {
    hits = {t_of(ray, segment->source()), t_of(ray, segment->target())};
    std::sort(hits.begin(), hits.end());
  }
  return hits;
}

using peers::given;
using peers::LibraryCall;

/// How `function` is asked with a ray, or a line, and a shape that the text makes.
template <class... V>
LibraryCall call_of(const char* function, const char* line, const Ray<double>& ray, const char* shape,
                    const peers::Given<V>&... inputs) {
  const Kernel::Vector_3 v = along(ray);
  const dvec3 direction(v.x(), v.y(), v.z());
  LibraryCall call(function, R"(#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;)");
  const std::string kind = line;
  call.add("K::$kind ray(Point($origin), K::Vector_3($direction));", given("kind", kind),
           given("origin", ray.origin), given("direction", direction));
  if (kind == "Line_3") call.add("", given("t_min", -infinity<double>));
  call.add(shape, inputs...);
  call.ask();
  return call;
}

/// What `shape` and the ray have in common, or the line where the ray goes on behind its origin.
template <class Object, class... V>
std::vector<double> common(const Ray<double>& ray, const Object& shape, const char* made,
                           const peers::Given<V>&... inputs) {
  const auto call = call_of("CGAL::intersection", ray.t_min < 0 ? "Line_3" : "Ray_3", ray, made, inputs...);
  std::vector<double> hits =
      ray.t_min < 0 ? t_of_all(ray, CGAL::intersection(Kernel::Line_3(at(ray.origin), along(ray)), shape))
                    : t_of_all(ray, CGAL::intersection(Kernel::Ray_3(at(ray.origin), along(ray)), shape));
  call.said(given("hit", !hits.empty()));
  std::erase_if(hits, [&](double t) { return !in_interval(ray, t); });
  return hits;
}

/// A ray in a flat figure's plane has a segment in common with it; the case format calls that no hit.
std::vector<double> crossing(std::vector<double> hits) {
  if (hits.size() == 2) hits.clear();
  return hits;
}

Kernel::Triangle_3 triangle_of(dvec3 a, dvec3 b, dvec3 c) {
  const Kernel::Triangle_3 made(at(a), at(b), at(c));
  if (made.is_degenerate()) throw Unsupported();
  return made;
}

std::vector<double> triangle(const Ray<double>& ray, dvec3 a, dvec3 b, dvec3 c) {
  return crossing(common(ray, triangle_of(a, b, c), R"(K::Triangle_3 shape(Point($a), Point($b), Point($c));
std::printf("hit = %d\n", bool(CGAL::intersection(ray, shape)));)",
                         given("a", a), given("b", b), given("c", c)));
}

std::vector<double> implicit(const Ray<double>& ray, dvec3 normal, double d) {
  return common(ray, Kernel::Plane_3(normal.x, normal.y, normal.z, d), R"(K::Plane_3 shape($normal, $d);
std::printf("hit = %d\n", bool(CGAL::intersection(ray, shape)));)",
                given("normal", normal), given("d", d));
}

std::vector<double> point_normal(const Ray<double>& ray, dvec3 point, dvec3 normal) {
  return common(ray, Kernel::Plane_3(at(point), Kernel::Vector_3(normal.x, normal.y, normal.z)),
                R"(K::Plane_3 shape(Point($point), K::Vector_3($normal));
std::printf("hit = %d\n", bool(CGAL::intersection(ray, shape)));)",
                given("point", point), given("normal", normal));
}

/// What the whole line has in common with the box: its ends are hits, as far as they are in the interval.
std::vector<double> box(const Ray<double>& ray, dvec3 low, dvec3 high) {
  if (low.x == high.x || low.y == high.y || low.z == high.z) throw Unsupported();
  const Kernel::Line_3 line(at(ray.origin), along(ray));
  const auto call =
      call_of("CGAL::intersection", "Line_3", ray, R"(K::Iso_cuboid_3 shape(Point($low), Point($high));
std::printf("hit = %d\n", bool(CGAL::intersection(ray, shape)));)",
              given("low", low), given("high", high));
  std::vector<double> hits = t_of_all(ray, CGAL::intersection(line, Kernel::Iso_cuboid_3(at(low), at(high))));
  call.said(given("hit", !hits.empty()));
  // Near hits of a far origin are lost where their points are rounded.
  for (const double t : hits)
    if (glm::length(ray.origin) > 8 * std::abs(t) * glm::length(ray.direction)) throw Unsupported();
  std::erase_if(hits, [&](double t) { return !in_interval(ray, t); });
  return hits;
}

bool sphere(const Ray<double>& ray, dvec3 center, double radius) {
  if (ray.t_min != 0 || ray.t_max != infinity<double> || radius == 0) throw Unsupported();
  const Kernel::Point_3 start = at(ray.origin);
  const Kernel::Sphere_3 surface(at(center), radius * radius);
  const double radius2 = radius * radius;
  const auto call =
      call_of("CGAL::do_intersect", "Ray_3", ray, R"(K::Sphere_3 shape(Point($center), $radius2);
std::printf("hit = %d\n", CGAL::do_intersect(shape, ray));)",
              given("center", center), given("radius2", radius2));
  const bool is_hit = CGAL::do_intersect(surface, Kernel::Ray_3(start, along(ray)));
  call.said(given("hit", is_hit));
  return is_hit;
}

Position position(const PointAndPolygon<double>& asked) {
  std::vector<Kernel::Point_2> vertices;
  for (const auto& [x, y] : asked.vertices) vertices.emplace_back(x, y);
  if (!CGAL::is_simple_2(vertices.begin(), vertices.end(), Kernel())) throw Unsupported();  // a precondition
  LibraryCall call("CGAL::bounded_side_2",
                   R"(#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
K::Point_2 corners[] = {$corners}, point($point);
std::printf("side = %d\n", CGAL::bounded_side_2(std::begin(corners), std::end(corners), point, K()));)",
                   given("corners", asked.vertices), given("point", asked.point),
                   given("vertices", asked.vertices));
  call.ask();
  const auto side = CGAL::bounded_side_2(vertices.begin(), vertices.end(),
                                         Kernel::Point_2(asked.point.x, asked.point.y), Kernel());
  call.said(given("side", static_cast<int>(side)));
  return side == CGAL::ON_BOUNDED_SIDE ? Position::inside
         : side == CGAL::ON_BOUNDARY   ? Position::boundary
                                       : Position::outside;
}

/// The nearest hit of an AABB tree with one triangle; rays are asked alone.
std::vector<double> tree(const Ray<double>& ray, dvec3 a, dvec3 b, dvec3 c) {
  if (ray.t_min < 0) throw Unsupported();
  using Triangles = std::list<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::iterator>;
  Triangles triangles{triangle_of(a, b, c)};
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> all(triangles.begin(), triangles.end());
  const auto call = call_of("CGAL::AABB_tree::first_intersection", "Ray_3", ray,
                            R"(#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
using Primitive = CGAL::AABB_triangle_primitive<K, K::Triangle_3*>;
K::Triangle_3 shape(Point($a), Point($b), Point($c));
CGAL::AABB_tree<CGAL::AABB_traits<K, Primitive>> tree(&shape, &shape + 1);
std::printf("hit = %d\n", bool(tree.first_intersection(ray)));)",
                            given("a", a), given("b", b), given("c", c));
  const auto found = all.first_intersection(Kernel::Ray_3(at(ray.origin), along(ray)));
  std::vector<double> hits;
  call.said(given("hit", bool(found)));
  if (!found) return hits;
  if (const auto* point = boost::relaxed_get<Point>(&found->first)) hits = {t_of(ray, *point)};
  std::erase_if(hits, [&](double t) { return !in_interval(ray, t); });
  return hits;
}

}  // namespace
}  // namespace rayproof

int main(int count, char** arguments) {
  using namespace rayproof;
  peers::introduce(count, arguments,
                   {"CGAL", CGAL_VERSION_STR, peers::built_with("-frounding-math -lgmp -lmpfr"),
                    "https://github.com/CGAL/cgal/issues"});
  if (count > 1 && std::string_view(arguments[1]) == "tree") return answer_cases(tree);
  return answer_cases(triangle, takes<ImplicitPlane>(implicit), takes<PointNormalPlane>(point_normal), box,
                      sphere, position);
}
