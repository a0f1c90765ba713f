#include "properties/diagnosis/models/solids/rounded_box.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "properties/claims/answers.hpp"
#include "properties/edges.hpp"

namespace rayproof::diagnosis {
namespace {

/// What a program may make of a box by rounding: middle and half lengths, these of the sizes or of the
/// middle, with faces that are rounded or not; min and size.
std::vector<Case> rounded_boxes(const Case& one) {
  Case in_doubles = one;  // which hold the sum of a rounded middle and a rounded half
  in_doubles.precision = Precision::float64;
  const auto rounded = [&](double x) { return round_to(one.precision, x); };
  std::vector<Case> all;
  for (int form = 0; form < 4; ++form) {
    const auto made = with_shape<Box<double>>(in_doubles, [&](const RayQuestion& /*asked*/, auto& box) {
      const Box<double> given = box;
      for (int axis = 0; axis < 3; ++axis) {
        const double low = given.min[axis], high = given.max[axis], size = rounded(high - low);
        const double middle = rounded(rounded(low + high) / 2);
        const double half = form == 1 ? rounded(high - middle) : rounded(size / 2);
        box.min[axis] = form == 3 ? low : middle - half;
        box.max[axis] = form == 3 ? rounded(low + size) : middle + half;
        if (form == 1 || form == 2) {
          box.min[axis] = rounded(box.min[axis]);
          box.max[axis] = rounded(box.max[axis]);
        }
      }
      return box.min != given.min || box.max != given.max;
    });
    all.insert(all.end(), made.begin(), made.end());
  }
  return all;
}

/// The box about its middle, where the ray's origin is as it is seen from there, rounded: from the rounded
/// middle, or from min and max.
std::vector<Case> seen_from_the_middle(const Case& one) {
  Case in_doubles = one;
  in_doubles.precision = Precision::float64;
  const auto rounded = [&](double x) { return round_to(one.precision, x); };
  std::vector<Case> all;
  for (const bool by_corners : {false, true}) {
    const auto made = with_shape<Box<double>>(in_doubles, [&](RayQuestion& asked, auto& box) {
      bool is_rounded = false;
      for (int axis = 0; axis < 3; ++axis) {
        const double low = box.min[axis], high = box.max[axis], origin = asked.ray.origin[axis];
        const double middle = rounded(rounded(low + high) / 2), half = rounded(rounded(high - low) / 2);
        const double seen =
            by_corners ? rounded(rounded(2 * origin - low) - high) / 2 : rounded(origin - middle);
        // A sum of long doubles shows whether anything was lost.
        is_rounded |= static_cast<long double>(origin) - low - half != seen + 0.0L;
        asked.ray.origin[axis] = seen;
        box.min[axis] = -half;
        box.max[axis] = half;
      }
      return is_rounded && !asked.transform;
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
  const double unit = roundoff_of(one.precision);
  const double off = farthest(numbers, right) * glm::length(asked.ray.direction);
  return off > 0 && off <= few * unit * std::max({largest.x, largest.y, largest.z});
}

}  // namespace

std::optional<bool> is_of_rounded_centre(const Case& one, const Answer& got, const Answer& exact) {
  const bool finds = finds_something(got);
  const std::vector<double> numbers = numbers_in(got), right = numbers_in(exact);
  std::vector<Case> boxes = rounded_boxes(one);
  for (const Case& seen : seen_from_the_middle(one)) boxes.push_back(seen);
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
