/// \file
/// GEOS 3.11, by its C interface: a point and a polygon, in double. Predicates are documented for valid
/// geometries; GEOSisValid says which those are.
#include <geos_c.h>

#include <memory>

#include "peers/reproduction.hpp"

namespace rayproof {
namespace {

struct DestroyGeometry {
  void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy(geometry); }
};
using Geometry = std::unique_ptr<GEOSGeometry, DestroyGeometry>;

Geometry polygon_of(const std::vector<Vec2<double>>& vertices) {
  const auto count = static_cast<unsigned>(vertices.size());
  GEOSCoordSequence* const ring = GEOSCoordSeq_create(count + 1, 2);
  for (unsigned i = 0; i <= count; ++i)
    GEOSCoordSeq_setXY(ring, i, vertices[i % count].x, vertices[i % count].y);
  return Geometry(GEOSGeom_createPolygon(GEOSGeom_createLinearRing(ring), nullptr, 0));
}

Position position(const PointAndPolygon<double>& asked) {
  using peers::given;
  std::vector<Vec2<double>> closed = asked.vertices;
  closed.push_back(closed.front());
  peers::LibraryCall call("GEOSContains", R"(#include <geos_c.h>
initGEOS(nullptr, nullptr);
double corners[][2] = {$ring};
const unsigned count = sizeof corners / sizeof *corners;
GEOSCoordSequence* ring = GEOSCoordSeq_copyFromBuffer(corners[0], count, 0, 0);
GEOSGeometry* polygon = GEOSGeom_createPolygon(GEOSGeom_createLinearRing(ring), nullptr, 0);
GEOSGeometry* point = GEOSGeom_createPointFromXY($point);
std::printf("valid = %d, contains = %d, covers = %d\n", GEOSisValid(polygon), GEOSContains(polygon, point),
GEOSCovers(polygon, point));)",
                          given("ring", closed), given("point", asked.point),
                          given("vertices", asked.vertices));
  call.ask();
  const Geometry polygon = polygon_of(asked.vertices);
  if (!polygon || GEOSisValid(polygon.get()) != 1) throw Unsupported();
  const Geometry point(GEOSGeom_createPointFromXY(asked.point.x, asked.point.y));
  const int contains = GEOSContains(polygon.get(), point.get());
  const int covers = GEOSCovers(polygon.get(), point.get());
  call.said(given("valid", 1), given("contains", contains), given("covers", covers));
  if (contains == 1) return Position::inside;
  return covers == 1 ? Position::boundary : Position::outside;
}

}  // namespace
}  // namespace rayproof

int main(int count, char** arguments) {
  using namespace rayproof;
  const std::string version = GEOSversion();
  peers::introduce(count, arguments,
                   {"GEOS", version.substr(0, version.find('-')), peers::built_with("-lgeos_c"),
                    "https://github.com/libgeos/geos/issues"});
  initGEOS(nullptr, nullptr);
  const int status = answer_cases(position);
  finishGEOS();
  return status;
}
