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
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkOBBTree.h>
#include <vtkObject.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkStaticCellLocator.h>
#include <vtkTriangle.h>
#include <vtkVersion.h>

#include <string_view>

#include "peers/reproduction.hpp"
#include "peers/segment.hpp"
#include "peers/simple_polygon.hpp"

namespace rayproof {
namespace {

using glm::dvec3;
using Hit = std::optional<double>;

using peers::given;
using peers::LibraryCall;

/// vtkPolygon fires random rays within the polygon's plane: the same for each case, so that an answer does
/// not depend on those before. A new program has this very seed.
void repeat_random_numbers() { vtkMath::RandomSeed(1177); }

/// Rays in the plane of the triangle, or so near to it that rounding decides, mean another thing to VTK.
void refuse_coplanar(const Ray<double>& ray, dvec3 a, dvec3 b, dvec3 c) {
  const dvec3 normal = cross(b - a, c - a);
  const double steepness = std::abs(dot(normal, ray.direction));
  if (steepness <= 1e-14 * glm::length(normal) * glm::length(ray.direction)) throw Unsupported();
}

Hit plane(const Ray<double>& ray, const PointNormalPlane& shape) {
  const double t_plane = dot(shape.point - ray.origin, shape.normal) / dot(ray.direction, shape.normal);
  const dvec3 passed = ray.origin + (std::isfinite(t_plane) ? std::abs(t_plane) : 1.0) * ray.direction;
  const auto segment = peers::segment_past<double>(
      ray, passed, glm::length(passed - ray.origin) + glm::length(ray.direction), true);
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

/// A cell met by a segment, by its own routine.
Hit meet(LibraryCall call, vtkCell& cell, std::span<const dvec3> vertices, const Ray<double>& ray,
         double tolerance = 0) {
  const auto segment = peers::segment_past<double>(ray, vertices, true);
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
  LibraryCall call("vtkPolygon::IntersectWithLine", R"(#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolygon.h>
vtkNew<vtkPolygon> cell;
double corners[][3] = {$vertices};
for (auto& p : corners) cell->GetPointIds()->InsertNextId(cell->GetPoints()->InsertNextPoint(p));)",
                   given("vertices", vertices));
  return meet(std::move(call), *cell, vertices, ray,
              1e-14 * size + 2 * peers::distance_from_plane(vertices, normal));
}

std::array<double, 6> bounds_of(dvec3 low, dvec3 high) {
  return {low.x, high.x, low.y, high.y, low.z, high.z};
}

std::vector<double> box(const Ray<double>& ray, dvec3 low, dvec3 high) {
  const auto segment = peers::segment_past<double>(ray, std::array{low, high});
  double s[2] = {0, 0};
  int faces[2];
  const auto bounds = bounds_of(low, high);
  std::vector<double> hits;
  LibraryCall call("vtkBox::IntersectWithLine", R"(#include <vtkBox.h>
double start[] = {$start}, end[] = {$end}, low[] = {$low}, high[] = {$high}, t[2] = {};
double bounds[] = {low[0], high[0], low[1], high[1], low[2], high[2]};
int face[2], hit = vtkBox::IntersectWithLine(bounds, start, end, t[0], t[1], nullptr, nullptr, face[0], face[1]);
std::printf("hit = %d, t1 = $g, t2 = $g\n", hit, hit * t[0], hit * t[1]);)",
                   given("start", segment.start), given("end", segment.end), given("low", low),
                   given("high", high));
  call.ask();
  const int hit = vtkBox::IntersectWithLine(bounds.data(), &segment.start.x, &segment.end.x, s[0], s[1],
                                            nullptr, nullptr, faces[0], faces[1]);
  call.said(given("hit", hit), given("t1", hit * s[0]), given("t2", hit * s[1]));
  if (hit != 0)
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
  LibraryCall call("vtkBox::IntersectBox", R"(#include <vtkBox.h>
double low[] = {$low}, high[] = {$high}, bounds[] = {low[0], high[0], low[1], high[1], low[2], high[2]};
double origin[] = {$origin}, direction[] = {$direction}, x[3], t = 0;
int hit = vtkBox::IntersectBox(bounds, origin, direction, x, t);
std::printf("hit = %d, t = $g\n", hit, t);)",
                   given("low", low), given("high", high), given("origin", segment.start),
                   given("direction", direction), given("t_max", 1.0));
  call.ask();
  const int hit = vtkBox::IntersectBox(bounds_of(low, high).data(), &segment.start.x, &direction.x, &x.x, s);
  call.said(given("hit", hit), given("t", s));
  if (hit == 0) return {};
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
  LibraryCall call("vtkPolygon::PointInPolygon", R"(#include <vtkMath.h>
#include <vtkPolygon.h>
double corners[][3] = {$vertices}, point[] = {$point, 0}, normal[] = {0, 0, 1};
double bounds[] = {$x0, $x1, $y0, $y1, 0, 0};
const int count = sizeof corners / sizeof *corners;
vtkMath::RandomSeed(1177);  // the rays within the plane are random
int inside = vtkPolygon::PointInPolygon(point, count, corners[0], bounds, normal);
std::printf("inside = %d\n", inside);)",
                   given("vertices", asked.vertices), given("point", asked.point), given("x0", bounds[0]),
                   given("x1", bounds[1]), given("y0", bounds[2]), given("y1", bounds[3]));
  call.ask();
  repeat_random_numbers();
  const int said = vtkPolygon::PointInPolygon(point, static_cast<int>(asked.vertices.size()), points.data(),
                                              bounds, normal);
  call.said(given("inside", said));
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
  const std::string name = std::is_same_v<Locator, vtkOBBTree> ? "vtkOBBTree" : "vtkStaticCellLocator";
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
  LibraryCall call(name + "::IntersectWithLine", R"(#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <$locator.h>
#include <vtkPolyData.h>
double corners[][3] = {{$a}, {$b}, {$c}}, start[] = {$start}, end[] = {$end}, t = 0, x[3], pcoords[3];
vtkNew<vtkPoints> points; vtkNew<vtkCellArray> cells; vtkNew<vtkPolyData> data; vtkNew<vtkGenericCell> cell;
points->SetDataTypeToDouble(), cells->InsertNextCell(3);
for (auto& corner : corners) cells->InsertCellPoint(points->InsertNextPoint(corner));
data->SetPoints(points), data->SetPolys(cells);
vtkNew<$locator> locator; locator->SetDataSet(data), locator->BuildLocator();
int part; vtkIdType id; int hit = locator->IntersectWithLine(start, end, 0, t, x, pcoords, part, id, cell);
std::printf("hit = %d, t = $g\n", hit, hit * t);)",
                   given("locator", name), given("a", a), given("b", b), given("c", c),
                   given("start", segment.start), given("end", segment.end));
  call.ask();
  const int hit =
      locator->IntersectWithLine(&segment.start.x, &segment.end.x, 0, s, x, coordinates, part, id, cell);
  call.said(given("hit", hit), given("t", hit * s));
  if (hit == 0) return {};
  return segment.t_at(s);
}

peers::Library vtk_library() {
  const std::string release = std::to_string(vtkVersion::GetVTKMajorVersion()) + "." +
                              std::to_string(vtkVersion::GetVTKMinorVersion());
  std::string flags = "-I/usr/include/vtk-" + release;
  for (const char* const part : {"FiltersGeneral", "CommonExecutionModel", "CommonDataModel", "CommonCore"})
    flags += " -lvtk" + std::string(part) + "-" + release;
  return {"VTK", vtkVersion::GetVTKVersion(), peers::built_with(flags),
          "https://gitlab.kitware.com/vtk/vtk/-/issues"};
}

}  // namespace
}  // namespace rayproof

int main(int count, char** arguments) {
  using namespace rayproof;
  vtkObject::GlobalWarningDisplayOff();
  peers::introduce(count, arguments, vtk_library());
  const std::string_view which = count > 1 ? arguments[1] : "";
  if (which == "tree") return answer_cases(located<vtkOBBTree>);
  if (which == "locator") return answer_cases(located<vtkStaticCellLocator>);
  if (which == "intersect-box") return answer_cases(intersect_box);
  if (which == "point-in-polygon") return answer_cases(is_in_polygon);
  return answer_cases(takes<PointNormalPlane>(plane), triangle, polygon, box);
}
