#include "properties/diagnosis/models/solids/slab_arithmetic.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "properties/diagnosis/models/solids/slabs.hpp"

namespace rayproof::diagnosis {
namespace {

/// How the t of a slab's planes are taken into the stretch so far, where one of them may be NaN.
enum class Way {
  by_if,           ///< where it is later, or earlier; near and far by the direction's sign
  by_if_both,      ///< the same, near and far by a comparison
  by_c_min_max,    ///< std::min(a, b) is b < a ? b : a
  by_c_turned,     ///< the same with the new t first
  by_fmin_fmax,    ///< NaN is left out
  by_nan_min_max,  ///< NaN stays: the ray misses
  by_early_out     ///< a miss where it begins after the end; the first slab is taken as it is
};
constexpr std::array all_ways{Way::by_if,        Way::by_if_both,     Way::by_c_min_max, Way::by_c_turned,
                              Way::by_fmin_fmax, Way::by_nan_min_max, Way::by_early_out};

struct Stretch {
  double first = -infinity<double>, last = infinity<double>;
  bool is_missed = false;
};

double min_of(double a, double b) { return b < a ? b : a; }
double max_of(double a, double b) { return a < b ? b : a; }

void take_by_sign(Stretch& s, double near, double far, Way way, bool is_first) {
  if (way == Way::by_early_out && is_first) {
    s.first = near;
    s.last = far;
    return;
  }
  if (way == Way::by_early_out && (s.first > far || near > s.last)) s.is_missed = true;
  if (near > s.first) s.first = near;
  if (far < s.last) s.last = far;
}

void take(Stretch& s, double a, double b, bool is_turned, Way way, bool is_first) {
  switch (way) {
    case Way::by_if:
    case Way::by_early_out:
      return take_by_sign(s, is_turned ? b : a, is_turned ? a : b, way, is_first);
    case Way::by_if_both:
      return take_by_sign(s, a > b ? b : a, a > b ? a : b, way, is_first);
    case Way::by_c_min_max:
      s.first = max_of(s.first, min_of(a, b));
      s.last = min_of(s.last, max_of(a, b));
      return;
    case Way::by_c_turned:
      s.first = max_of(min_of(a, b), s.first);
      s.last = min_of(max_of(a, b), s.last);
      return;
    case Way::by_fmin_fmax:
      s.first = std::fmax(s.first, std::fmin(a, b));
      s.last = std::fmin(s.last, std::fmax(a, b));
      return;
    case Way::by_nan_min_max:
      if (std::isnan(a) || std::isnan(b)) s.is_missed = true;
      s.first = std::fmax(s.first, std::fmin(a, b));
      s.last = std::fmin(s.last, std::fmax(a, b));
  }
}

RayAnswer found_in(const Case& one, const Cube& cube, Way way) {
  Stretch s;
  for (int axis = 0; axis < 3; ++axis) {
    const double over = 1 / cube.ray.direction[axis], o = cube.ray.origin[axis];
    take(s, (cube.low[axis] - o) * over, (cube.high[axis] - o) * over, std::signbit(over), way, axis == 0);
  }
  RayAnswer line;
  // Of what is NaN no comparison is true, and no t is in the interval.
  if (s.is_missed || s.last < s.first) return line;
  line.hits.push_back(s.first);
  if (s.first != s.last) line.hits.push_back(s.last);
  return hits_where(line, [&](double t) { return in_interval(ray_question(one)->ray, t); });
}

bool is_in_face(const Cube& cube) {
  for (int axis = 0; axis < 3; ++axis) {
    const double o = cube.ray.origin[axis];
    if (cube.ray.direction[axis] == 0 && (o == cube.low[axis] || o == cube.high[axis])) return true;
  }
  return false;
}

}  // namespace

Answers reciprocal_in_float(const Case& one, const Answer& /*exact*/) {
  const auto cube = one.precision == Precision::float32 ? std::nullopt : cube_in(one);
  if (!cube) return {};
  Stretch s;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = cube->ray.origin[axis], d = cube->ray.direction[axis];
    if (d == 0 && (o < cube->low[axis] || o > cube->high[axis])) return {RayAnswer{}};
    if (d == 0) continue;
    const double over = static_cast<float>(1 / d);
    take(s, (cube->low[axis] - o) * over, (cube->high[axis] - o) * over, false, Way::by_if_both, axis == 0);
  }
  return inside_from(one, s.first, s.last);
}

Answers nan_in_slab(const Case& one, const Answer& /*exact*/) {
  const auto cube = cube_in(one);
  if (!cube || !is_in_face(*cube)) return {};
  Answers answers;
  for (const Way way : all_ways) answers.emplace_back(found_in(one, *cube, way));
  return answers;
}

Answers stops_at_parallel_slab(const Case& one, const Answer& /*exact*/) {
  const auto cube = cube_in(one);
  if (!cube) return {};
  const glm::dvec3 &o = cube->ray.origin, &d = cube->ray.direction;
  if (d.x != 0 && d.y != 0 && d.z != 0) return {};
  Answers answers;
  for (const bool is_backward : {false, true}) {
    Stretch s;
    for (int k = 0; k < 3; ++k) {
      const int axis = is_backward ? 2 - k : k;
      if (d[axis] == 0) {
        s.is_missed = o[axis] < cube->low[axis] || o[axis] > cube->high[axis];
        break;
      }
      take(s, (cube->low[axis] - o[axis]) / d[axis], (cube->high[axis] - o[axis]) / d[axis], false,
           Way::by_if_both, k == 0);
    }
    answers.push_back(s.is_missed ? Answer{RayAnswer{}} : inside_from(one, s.first, s.last).front());
  }
  return answers;
}

}  // namespace rayproof::diagnosis
