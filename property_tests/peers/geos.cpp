/// \file
/// GEOS 3.11, by its C interface: a point and a polygon, in double. Predicates are documented for valid
/// geometries; GEOSisValid says which those are.
#include <geos_c.h>

#include <memory>

#include "answer_cases.hpp"

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
  const Geometry polygon = polygon_of(asked.vertices);
  if (!polygon || GEOSisValid(polygon.get()) != 1) throw Unsupported();
  const Geometry point(GEOSGeom_createPointFromXY(asked.point.x, asked.point.y));
  if (GEOSContains(polygon.get(), point.get()) == 1) return Position::inside;
  return GEOSCovers(polygon.get(), point.get()) == 1 ? Position::boundary : Position::outside;
}

}  // namespace
}  // namespace rayproof

int main() {
  initGEOS(nullptr, nullptr);
  const int status = rayproof::answer_cases(rayproof::position);
  finishGEOS();
  return status;
}
