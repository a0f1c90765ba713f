/// \file
/// VTK 9.1: the routines of its cells and boxes (no argument), vtkOBBTree (`tree`) and vtkStaticCellLocator
/// (`locator`) around one cell, vtkBox::IntersectBox (`intersect-box`), and vtkPolygon::PointInPolygon
/// (`point-in-polygon`, apart, since it does not return from all cases). All take the ends of a segment, t
/// running from 0 to 1 (IntersectBox: origin and direction), in double. A cell's tolerance is a length that
/// only says how far outside a hit may be: it is 0, or the least that rounding asks for. Of a ray in a
/// triangle's plane VTK documents that it meets the triangle, so such rays are not asked. Degenerate polygons
/// are excluded by the -1 of PointInPolygon. vtkSphere and vtkCylinder have no routine for rays.
#include <vtkBox.h>
#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkOBBTree.h>
#include <vtkObject.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkStaticCellLocator.h>
#include <vtkTriangle.h>

#include <string_view>

#include "peers/segment.hpp"
#include "peers/simple_polygon.hpp"

namespace rayproof {
namespace {

using glm::dvec3;
using Hit = std::optional<double>;

/// Rays in the plane of the triangle, or so near to it that rounding decides, mean another thing to VTK.
void refuse_coplanar(const Ray<double>& ray, dvec3 a, dvec3 b, dvec3 c) {
  const dvec3 normal = cross(b - a, c - a);
  const double steepness = std::abs(dot(normal, ray.direction));
  if (steepness <= 1e-14 * glm::length(normal) * glm::length(ray.direction)) throw Unsupported();
}

Hit plane(const Ray<double>& ray, const PointNormalPlane& given) {
  const double t_plane = dot(given.point - ray.origin, given.normal) / dot(ray.direction, given.normal);
  const dvec3 passed = ray.origin + (std::isfinite(t_plane) ? std::abs(t_plane) : 1.0) * ray.direction;
  const auto segment = peers::segment_past<double>(
      ray, passed, glm::length(passed - ray.origin) + glm::length(ray.direction), true);
  dvec3 normal = given.normal, point = given.point, x(0);
  double s = 0;
  if (vtkPlane::IntersectWithLine(&segment.start.x, &segment.end.x, &normal.x, &point.x, s, &x.x) == 0)
    return {};
  return segment.t_at(s);
}

/// A cell met by a segment, by its own routine.
Hit meet(vtkCell& cell, std::span<const dvec3> vertices, const Ray<double>& ray, double tolerance = 0) {
  const auto segment = peers::segment_past<double>(ray, vertices, true);
  double s = 0, x[3], coordinates[3];
  int part = 0;
  if (cell.IntersectWithLine(&segment.start.x, &segment.end.x, tolerance, s, x, coordinates, part) == 0)
    return {};
  return segment.t_at(s);
}

Hit triangle(const Ray<double>& ray, dvec3 a, dvec3 b, dvec3 c) {
  refuse_coplanar(ray, a, b, c);
  static const vtkNew<vtkTriangle> cell;
  const std::array vertices{a, b, c};
  for (vtkIdType i = 0; i < 3; ++i) cell->GetPoints()->SetPoint(i, &vertices[static_cast<std::size_t>(i)].x);
  return meet(*cell, vertices, ray);
}

Hit polygon(const Ray<double>& ray, const std::vector<dvec3>& vertices) {
  if (!peers::is_simple(vertices)) throw Unsupported();
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
  return meet(*cell, vertices, ray, 1e-14 * size + 2 * peers::distance_from_plane(vertices, normal));
}

std::array<double, 6> bounds_of(dvec3 low, dvec3 high) {
  return {low.x, high.x, low.y, high.y, low.z, high.z};
}

std::vector<double> box(const Ray<double>& ray, dvec3 low, dvec3 high) {
  const auto segment = peers::segment_past<double>(ray, std::array{low, high});
  double s[2];
  int faces[2];
  const auto bounds = bounds_of(low, high);
  std::vector<double> hits;
  if (vtkBox::IntersectWithLine(bounds.data(), &segment.start.x, &segment.end.x, s[0], s[1], nullptr, nullptr,
                                faces[0], faces[1]) != 0)
    for (const int i : {0, 1})
      if (faces[i] >= 0) hits.push_back(segment.t_at(s[i]));
  return hits;
}

/// "Valid intersections will only occur between 0<=t<=1"; a ray that begins inside is said to hit at 0.
Hit intersect_box(const Ray<double>& ray, dvec3 low, dvec3 high) {
  const auto segment = peers::segment_past<double>(ray, std::array{low, high});
  if (glm::all(glm::lessThanEqual(low, segment.start)) && glm::all(glm::lessThanEqual(segment.start, high)))
    throw Unsupported();
  const dvec3 direction = segment.end - segment.start;
  dvec3 x(0);
  double s = 0;
  if (vtkBox::IntersectBox(bounds_of(low, high).data(), &segment.start.x, &direction.x, &x.x, s) == 0)
    return {};
  return segment.t_at(s);
}

bool is_in_polygon(const PointAndPolygon<double>& asked) {
  if (!peers::is_simple(asked.vertices)) throw Unsupported();
  std::vector<double> points;
  double bounds[6] = {
      asked.vertices[0].x, asked.vertices[0].x, asked.vertices[0].y, asked.vertices[0].y, 0, 0};
  for (const auto& [x, y] : asked.vertices) {
    points.insert(points.end(), {x, y, 0});
    bounds[0] = std::min(bounds[0], x), bounds[1] = std::max(bounds[1], x);
    bounds[2] = std::min(bounds[2], y), bounds[3] = std::max(bounds[3], y);
  }
  double point[3] = {asked.point.x, asked.point.y, 0}, normal[3] = {0, 0, 1};
  const int said = vtkPolygon::PointInPolygon(point, static_cast<int>(asked.vertices.size()), points.data(),
                                              bounds, normal);
  if (said < 0) throw Unsupported();
  return said == 1;
}

/// One cell as a data set.
vtkNew<vtkPolyData> data_of(std::span<const dvec3> vertices) {
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(vertices.size()));
  for (const dvec3& vertex : vertices) cells->InsertCellPoint(points->InsertNextPoint(&vertex.x));
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

/// A triangle met through a locator around it.
template <class Locator>
Hit located(const Ray<double>& ray, dvec3 a, dvec3 b, dvec3 c) {
  refuse_coplanar(ray, a, b, c);
  const std::array vertices{a, b, c};
  const auto segment = peers::segment_past<double>(ray, vertices, true);
  const vtkNew<Locator> locator;
  locator->SetDataSet(data_of(vertices));
  locator->BuildLocator();
  double s = 0, x[3], coordinates[3];
  int part = 0;
  vtkIdType id = 0;
  const vtkNew<vtkGenericCell> cell;
  if (locator->IntersectWithLine(&segment.start.x, &segment.end.x, 0, s, x, coordinates, part, id, cell) == 0)
    return {};
  return segment.t_at(s);
}

}  // namespace
}  // namespace rayproof

int main(int count, char** arguments) {
  using namespace rayproof;
  vtkObject::GlobalWarningDisplayOff();
  const std::string_view which = count > 1 ? arguments[1] : "";
  if (which == "tree") return answer_cases(located<vtkOBBTree>);
  if (which == "locator") return answer_cases(located<vtkStaticCellLocator>);
  if (which == "intersect-box") return answer_cases(intersect_box);
  if (which == "point-in-polygon") return answer_cases(is_in_polygon);
  return answer_cases(takes<PointNormalPlane>(plane), triangle, polygon, box);
}
