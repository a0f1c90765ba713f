#include <vtkBox.h>

#include "peers/segment.hpp"
#include "peers/vtk/routines.hpp"

namespace rayproof::peers::vtk {
namespace {

using glm::dvec3;

std::array<double, 6> bounds_of(dvec3 low, dvec3 high) {
  return {low.x, high.x, low.y, high.y, low.z, high.z};
}

}  // namespace

std::vector<double> box(const Ray<double>& ray, dvec3 low, dvec3 high) {
  const auto segment = segment_past<double>(ray, std::array{low, high});
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
  // An end of the segment that is in the box has no face; where the line enters or leaves there, it is a hit
  // all the same.
  const dvec3 d = segment.end - segment.start;
  const auto crosses_at = [&](const dvec3& end, const dvec3& rising, const dvec3& falling) {
    return glm::any(glm::notEqual(d, dvec3(0)) && glm::mix(glm::equal(end, falling), glm::equal(end, rising),
                                                           glm::greaterThan(d, dvec3(0))));
  };
  const bool counts[2] = {faces[0] >= 0 || crosses_at(segment.start, low, high),
                          faces[1] >= 0 || crosses_at(segment.end, high, low)};
  if (hit != 0)
    for (const int i : {0, 1})
      if (counts[i]) hits.push_back(segment.t_at(s[i]));
  return hits;
}

/// "Valid intersections will only occur between 0<=t<=1"; a ray that begins inside is said to hit at 0.
Hit intersect_box(const Ray<double>& ray, dvec3 low, dvec3 high) {
  const auto segment = segment_past<double>(ray, std::array{low, high});
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

}  // namespace rayproof::peers::vtk
