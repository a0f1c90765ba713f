#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkPolygon.h>
#include <vtkTriangle.h>

#include "peers/segment.hpp"
#include "peers/simple_polygon.hpp"
#include "peers/vtk/routines.hpp"

namespace rayproof::peers::vtk {
namespace {

using glm::dvec3;

/// A cell met by a segment, by its own routine.
Hit meet(LibraryCall call, vtkCell& cell, std::span<const dvec3> vertices, const Ray<double>& ray,
         double tolerance = 0) {
  const auto segment = segment_past<double>(ray, vertices, true);
  call.add(R"(double start[] = {$start}, end[] = {$end}, t = 0, x[3], pcoords[3];
int part = 0, hit = cell->IntersectWithLine(start, end, $tolerance, t, x, pcoords, part);
std::printf("hit = %d, t = $g\n", hit, t);)",
           given("start", segment.start), given("end", segment.end), given("tolerance", tolerance));
  call.ask();
  double s = 0, x[3], coordinates[3];
  int part = 0;
  const int hit =
      cell.IntersectWithLine(&segment.start.x, &segment.end.x, tolerance, s, x, coordinates, part);
  call.said(given("hit", hit), given("t", s));
  if (hit == 0) return {};
  return segment.t_at(s);
}

}  // namespace

Hit plane(const Ray<double>& ray, const PointNormalPlane& shape) {
  const double t_plane = dot(shape.point - ray.origin, shape.normal) / dot(ray.direction, shape.normal);
  const dvec3 passed = ray.origin + (std::isfinite(t_plane) ? std::abs(t_plane) : 1.0) * ray.direction;
  const auto segment =
      segment_past<double>(ray, passed, glm::length(passed - ray.origin) + glm::length(ray.direction), true);
  dvec3 normal = shape.normal, point = shape.point, x(0);
  double s = 0;
  LibraryCall call("vtkPlane::IntersectWithLine", R"(#include <vtkPlane.h>
double start[] = {$start}, end[] = {$end}, t = 0, x[3];
double normal[] = {$normal}, point[] = {$point};
int hit = vtkPlane::IntersectWithLine(start, end, normal, point, t, x);
std::printf("hit = %d, t = $g\n", hit, t);)",
                   given("start", segment.start), given("end", segment.end), given("normal", normal),
                   given("point", point));
  call.ask();
  const int hit = vtkPlane::IntersectWithLine(&segment.start.x, &segment.end.x, &normal.x, &point.x, s, &x.x);
  call.said(given("hit", hit), given("t", s));
  if (hit == 0) return {};
  return segment.t_at(s);
}

Hit triangle(const Ray<double>& ray, dvec3 a, dvec3 b, dvec3 c) {
  refuse_coplanar(ray, a, b, c);
  static const vtkNew<vtkTriangle> cell;
  const std::array vertices{a, b, c};
  for (vtkIdType i = 0; i < 3; ++i) cell->GetPoints()->SetPoint(i, &vertices[static_cast<std::size_t>(i)].x);
  LibraryCall call("vtkTriangle::IntersectWithLine", R"(#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTriangle.h>
vtkNew<vtkTriangle> cell;
double corners[][3] = {{$a}, {$b}, {$c}};
for (int i = 0; i < 3; ++i) cell->GetPoints()->SetPoint(i, corners[i]);)",
                   given("a", a), given("b", b), given("c", c));
  return meet(std::move(call), *cell, vertices, ray);
}

Hit polygon(const Ray<double>& ray, const std::vector<dvec3>& vertices) {
  if (!is_simple(vertices)) throw Unsupported();
  const vtkNew<vtkPolygon> cell;
  for (const dvec3& vertex : vertices) {
    const vtkIdType id = cell->GetPoints()->InsertNextPoint(&vertex.x);
    cell->GetPointIds()->InsertNextId(id);
  }
  // Its hits must be within the tolerance of its planes, which rounding alone takes hits and vertices off by.
  dvec3 normal(0);
  vtkPolygon::ComputeNormal(cell->GetPoints(), &normal.x);
  double size = glm::length(ray.origin);
  for (const dvec3& vertex : vertices) size = std::max(size, glm::length(vertex));
  const double tolerance = 1e-14 * size + 2 * distance_from_plane(vertices, normal);
  // As near to a side as that, either answer is what was asked for.
  const double t_plane = dot(vertices[0] - ray.origin, normal) / dot(ray.direction, normal);
  constexpr double clear_of_it = 10;
  if (distance_from_sides(vertices, ray.origin + t_plane * ray.direction) < clear_of_it * tolerance)
    throw Unsupported();
  LibraryCall call("vtkPolygon::IntersectWithLine", R"(#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolygon.h>
vtkNew<vtkPolygon> cell;
double corners[][3] = {$vertices};
for (auto& p : corners) cell->GetPointIds()->InsertNextId(cell->GetPoints()->InsertNextPoint(p));)",
                   given("vertices", vertices));
  repeat_random_numbers();
  return meet(std::move(call), *cell, vertices, ray, tolerance);
}

}  // namespace rayproof::peers::vtk
