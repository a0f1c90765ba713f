/// \file
/// Boost.Geometry 1.74: a point within a polygon, in float and double. Its documentation asks for valid
/// polygons (bg::is_valid: closed, rightly oriented, not crossing themselves); `correct` sees to the first
/// two.
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/version.hpp>

#include <algorithm>

#include "peers/reproduction.hpp"

namespace rayproof {
namespace {

namespace bg = boost::geometry;

constexpr const char* source = R"(#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<$T>;
bg::model::polygon<Point> polygon;
$T corners[][2] = {$vertices};
for (auto& [x, y] : corners) bg::append(polygon, Point(x, y));
bg::correct(polygon);
Point point($point);
std::printf("valid = %d, within = %d, covered_by = %d\n", bg::is_valid(polygon), bg::within(point, polygon),
bg::covered_by(point, polygon));)";

template <class T>
Position position(const PointAndPolygon<T>& asked) {
  using Point = bg::model::d2::point_xy<T>;
  peers::LibraryCall call("boost::geometry::within", source, peers::given("point", asked.point),
                          peers::given("vertices", asked.vertices));
  call.ask();
  bg::model::polygon<Point> polygon;
  for (const auto& [x, y] : asked.vertices) bg::append(polygon, Point(x, y));
  bg::correct(polygon);
  if (!bg::is_valid(polygon)) throw Unsupported();
  const Point point(asked.point.x, asked.point.y);
  const bool is_within = bg::within(point, polygon), is_covered = bg::covered_by(point, polygon);
  call.said(peers::given("valid", true), peers::given("within", is_within),
            peers::given("covered_by", is_covered));
  if (is_within) return Position::inside;
  return is_covered ? Position::boundary : Position::outside;
}

}  // namespace
}  // namespace rayproof

int main(int count, char** arguments) {
  using namespace rayproof;
  std::string version = BOOST_LIB_VERSION;
  std::replace(version.begin(), version.end(), '_', '.');
  peers::introduce(
      count, arguments,
      {"Boost.Geometry", version, peers::built_with(""), "https://github.com/boostorg/geometry/issues"});
  return answer_cases(position<float>, position<double>);
}
