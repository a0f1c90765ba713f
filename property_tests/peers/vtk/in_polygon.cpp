#include <vtkPolygon.h>

#include "peers/simple_polygon.hpp"
#include "peers/vtk/routines.hpp"

namespace rayproof::peers::vtk {

bool is_in_polygon(const PointAndPolygon<double>& asked) {
  if (!is_simple(asked.vertices)) throw Unsupported();
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

}  // namespace rayproof::peers::vtk
