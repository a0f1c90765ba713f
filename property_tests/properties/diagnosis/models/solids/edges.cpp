#include "properties/diagnosis/models/solids/edges.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "properties/claims/answers.hpp"
#include "properties/edges.hpp"

namespace rayproof::diagnosis {
namespace {

/// How far a point is outside the box that is smaller by the margin on each side.
double apart_from_core(const Box<double>& box, const glm::dvec3& point, double margin) {
  return glm::length(glm::max(glm::max(box.min + margin - point, point - (box.max - margin)), 0.0));
}

/// The least of that on the line between two t: it is convex along a line.
double least_apart(const Box<double>& box, const Ray<double>& ray, double from, double to, double margin) {
  const auto apart_at = [&](double t) { return apart_from_core(box, point_at(ray, t), margin); };
  for (int step = 0; step < 100; ++step) {
    const double before = from + (to - from) / 3, after = to - (to - from) / 3;
    if (apart_at(before) <= apart_at(after))
      to = after;
    else
      from = before;
  }
  return apart_at((from + to) / 2);
}

/// Whether the line passes the inside of the solid, and does not only touch it or run in a face.
bool goes_on_inside(const Case& one) {
  const HitList line = hits_of_line(one).hits;
  if (line.count < 2) return false;
  const auto cube = cube_in(one);
  if (!cube) return true;
  const glm::dvec3 size = cube->high - cube->low;
  const glm::dvec3 share = (point_at(cube->ray, (line.t[0] + line.t[1]) / 2) - cube->low) / size;
  const auto is_inside = [](double x) { return 0x1p-20 < x && x < 1 - 0x1p-20; };
  return is_inside(share.x) && is_inside(share.y) && is_inside(share.z);
}

/// One axis of a box whose middle is compared with the ray's origin: how far `seen` apart they are, twice or
/// once, and `half`, the size or half of it. Whether the origin lies in between is then as these two say,
/// however their sum is rounded.
void put_around(double origin, double seen, double half, double& low, double& high) {
  low = origin - seen - half;
  high = origin - seen + half;
  if (seen > half) high = std::min(high, std::nextafter(origin, -infinity<double>));
  if (-seen > half) low = std::max(low, std::nextafter(origin, infinity<double>));
  if (std::abs(seen) > half) return;
  low = std::min(low, origin);
  high = std::max(high, origin);
}

/// What a program may make of a box by rounding: middle and half lengths, these of the sizes or of the
/// middle, with faces that are rounded or not; the middle as it is seen from the ray's origin, by itself or
/// from min and max; min and size.
std::vector<Case> rounded_boxes(const Case& one) {
  Case in_doubles = one;  // which hold the sum of a rounded middle and a rounded half
  in_doubles.precision = Precision::float64;
  const auto rounded = [&](double x) { return round_to(one.precision, x); };
  std::vector<Case> all;
  for (int form = 0; form < 6; ++form) {
    const bool is_seen = form == 3 || form == 5;
    const auto made = with_shape<Box<double>>(in_doubles, [&](const RayQuestion& asked, auto& box) {
      const Box<double> given = box;
      for (int axis = 0; axis < 3; ++axis) {
        const double low = given.min[axis], high = given.max[axis], size = rounded(high - low);
        const double origin = asked.ray.origin[axis], middle = rounded(rounded(low + high) / 2);
        const double half = form == 1 ? rounded(high - middle) : rounded(size / 2);
        box.min[axis] = form == 4 ? low : middle - half;
        box.max[axis] = form == 4 ? rounded(low + size) : middle + half;
        if (form == 3) put_around(origin, rounded(origin - middle), half, box.min[axis], box.max[axis]);
        if (form == 5)
          put_around(origin, rounded(rounded(2 * origin - low) - high) / 2, size / 2, box.min[axis],
                     box.max[axis]);
        if (form == 1 || form == 2) {
          box.min[axis] = rounded(box.min[axis]);
          box.max[axis] = rounded(box.max[axis]);
        }
      }
      return !(is_seen && asked.transform) && (box.min != given.min || box.max != given.max);
    });
    all.insert(all.end(), made.begin(), made.end());
  }
  return all;
}

/// By how much the worst of some numbers is off.
double farthest(const std::vector<double>& numbers, const std::vector<double>& others) {
  double worst = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) worst = std::max(worst, std::abs(numbers[i] - others[i]));
  return worst;
}

/// Whether the hits are off by about the last digit of the box's coordinates, and none is missing.
bool is_off_by_few_units(const Case& one, const std::vector<double>& numbers,
                         const std::vector<double>& right) {
  constexpr double few = 8;
  const auto* box = shape_in<Box<double>>(one);
  const RayQuestion& asked = *ray_question(one);
  if (box == nullptr || asked.transform || numbers.empty() || numbers.size() > right.size()) return false;
  const glm::dvec3 largest = glm::max(glm::abs(box->min), glm::abs(box->max));
  const double unit = one.precision == Precision::float32 ? 0x1p-24 : 0x1p-53;
  const double off = farthest(numbers, right) * glm::length(asked.ray.direction);
  return off > 0 && off <= few * unit * std::max({largest.x, largest.y, largest.z});
}

}  // namespace

std::optional<bool> missed_through_edge(const Case& one, const Answer& got, const Answer& exact) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr || finds_something(got) || !finds_something(exact)) return std::nullopt;
  const double t = std::get<RayAnswer>(exact).hits.t[0];
  constexpr double from_afar = 32;  // times as much rounding, where what leads to the hit cancels
  return is_at_edge(one, t, from_afar * share_of_rounding(one.precision)) && goes_on_inside(one);
}

std::optional<bool> has_rounded_edges(const Case& one, const Answer& got, const Answer& exact) {
  const auto* box = shape_in<Box<double>>(one);
  if (box == nullptr || !finds_something(exact) || std::get<RayAnswer>(got).verdict_only) return std::nullopt;
  if (is_of_rounded_centre(one, got, exact)) return std::nullopt;
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const glm::dvec3 sides = box->max - box->min;
  const double margin = std::min({sides.x, sides.y, sides.z}) / 8;
  const HitList &hits = std::get<RayAnswer>(exact).hits, &found = std::get<RayAnswer>(got).hits;
  if (!(margin > 0)) return std::nullopt;
  if (found.count == 0) {
    const double last = hits.t.at(hits.count - 1);
    return least_apart(*box, ray, std::max(hits.count > 1 ? hits.t[0] : ray.t_min, ray.t_min), last, margin) >
           margin;
  }
  const double t = found.t[0], near = share_of_rounding(one.precision) * size_of_scene(one);
  const glm::dvec3 place = point_at(ray, t);
  if (std::abs(t - hits.t[0]) * glm::length(ray.direction) <= near) return std::nullopt;
  const bool is_inside = apart_from_core(*box, place, 0) <= near;
  return t > hits.t[0] && is_inside && apart_from_core(*box, place, margin) >= margin;
}

std::optional<bool> is_of_rounded_centre(const Case& one, const Answer& got, const Answer& exact) {
  const bool finds = finds_something(got);
  const std::vector<double> numbers = numbers_in(got), right = numbers_in(exact);
  const std::vector<Case> boxes = rounded_boxes(one);
  if (!boxes.empty() && is_off_by_few_units(one, numbers, right)) return true;
  for (const Case& rounded : boxes) {
    const Answer foreseen = oracle::answer(rounded);
    if (finds_something(foreseen) != finds_something(exact)) {
      if (finds == finds_something(foreseen)) return true;
      continue;
    }
    const std::vector<double> other = numbers_in(foreseen);
    if (numbers.empty() || numbers.size() > other.size() || numbers.size() > right.size()) continue;
    if (2 * farthest(numbers, other) < farthest(numbers, right)) return true;
  }
  return std::nullopt;
}

}  // namespace rayproof::diagnosis
