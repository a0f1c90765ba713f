#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkOBBTree.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include "peers/segment.hpp"
#include "peers/vtk/routines.hpp"

namespace rayproof::peers::vtk {
namespace {

using glm::dvec3;

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
  const auto segment = segment_past<double>(ray, vertices, true);
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

}  // namespace

Hit in_tree(const Ray<double>& ray, dvec3 a, dvec3 b, dvec3 c) { return located<vtkOBBTree>(ray, a, b, c); }
Hit in_locator(const Ray<double>& ray, dvec3 a, dvec3 b, dvec3 c) {
  return located<vtkStaticCellLocator>(ray, a, b, c);
}

}  // namespace rayproof::peers::vtk
