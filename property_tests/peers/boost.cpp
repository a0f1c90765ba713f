/// \file
/// Boost.Geometry 1.74: a point within a polygon, in float and double. Its documentation asks for valid
/// polygons (bg::is_valid: closed, rightly oriented, not crossing themselves); `correct` sees to the first
/// two.
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include "answer_cases.hpp"

namespace rayproof {
namespace {

namespace bg = boost::geometry;

template <class T>
Position position(const PointAndPolygon<T>& asked) {
  using Point = bg::model::d2::point_xy<T>;
  bg::model::polygon<Point> polygon;
  for (const auto& [x, y] : asked.vertices) bg::append(polygon, Point(x, y));
  bg::correct(polygon);
  if (!bg::is_valid(polygon)) throw Unsupported();
  const Point point(asked.point.x, asked.point.y);
  if (bg::within(point, polygon)) return Position::inside;
  return bg::covered_by(point, polygon) ? Position::boundary : Position::outside;
}

}  // namespace
}  // namespace rayproof

int main() { return rayproof::answer_cases(rayproof::position<float>, rayproof::position<double>); }
