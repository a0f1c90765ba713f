#include "properties/diagnosis/models/hits/digits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <span>

#include "oracle/oracle.hpp"
#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/plane_hit.hpp"
#include "properties/numbers.hpp"

namespace rayproof::diagnosis {
namespace {

/// Whether all numbers of an answer are short; nothing where the exact ones are so, or there is none but 0.
template <class IsShort>
std::optional<bool> if_short(const Answer& got, const Answer& exact, IsShort&& is_short) {
  const std::vector<double> numbers = numbers_in(got), exactly = numbers_in(exact);
  if (std::ranges::all_of(numbers, [](double x) { return x == 0; }) || std::ranges::all_of(exactly, is_short))
    return std::nullopt;
  return std::ranges::all_of(numbers, is_short);
}

/// By how much the worst of the answer's numbers is off; nothing where it gives none, or more than there are.
std::optional<double> largest_error(const Answer& got, const Answer& exact) {
  const std::vector<double> numbers = numbers_in(got), exactly = numbers_in(exact);
  if (numbers.empty() || numbers.size() > exactly.size()) return std::nullopt;
  double worst = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) worst = std::max(worst, std::abs(numbers[i] - exactly[i]));
  return worst;
}

bool is_float(double x) { return !std::isfinite(x) || static_cast<double>(static_cast<float>(x)) == x; }

/// Whether a product of three of the case's numbers may overflow or vanish in a float.
bool is_beyond_float(const Case& one) {
  bool is_beyond = false;
  each_number_of(one, [&](double x) {
    is_beyond = is_beyond || (x != 0 && std::isfinite(x) && std::abs(std::ilogb(x)) > 42);
  });
  return is_beyond;
}

/// Whether a hit is as far from the surface, or a wrong verdict from being right, as a float's rounding of
/// the scene puts it, and a double's does not: what cancels in t does not there. Of a triangle or a polygon
/// plain doubles are right to their bound, and all that is wrong may be a float's, its range too.
bool is_off_by_a_float(const Case& one, const oracle::Judgement& judgement) {
  constexpr double generous = 1024;  // times what plain methods lose
  const double off = std::max(judgement.wrong ? judgement.margin : 0, judgement.residual);
  const double far = judgement.far;
  if (plane_hit(one))
    return (generous < off && off < 0x1p34 * far) || (judgement.wrong && is_beyond_float(one));
  return 0x1p19 < off && off < 0x1p34 && off > generous * far * far;
}

/// Whether the worst error is one of float's rounding. More says nothing of numbers that nearly cancel; a
/// little less is luck, or a small share of the whole. Much less says nothing where a float holds the case's
/// numbers, or those of the answer: it may have held all that led to it.
std::optional<bool> is_of_float_rounding(const Case& one, double worst, std::span<const double> exact) {
  if (worst > 0x1p-30) return worst < 0x1p-19 ? std::optional(true) : std::nullopt;
  if (worst > 0x1p-45) return std::nullopt;
  bool are_floats = true;
  each_number_of(one, [&](double x) { are_floats = are_floats && is_float(x); });
  return are_floats || std::ranges::all_of(exact, is_float) ? std::nullopt : std::optional(false);
}

}  // namespace

std::optional<bool> is_of_float(const Case& one, const Answer& got, const Answer& exact) {
  if (one.precision == Precision::float32) return std::nullopt;
  return if_short(got, exact, is_float);
}

std::optional<bool> is_right_to_float(const Case& one, const Answer& got, const Answer& exact) {
  if (one.precision == Precision::float32) return std::nullopt;
  if (is_off_by_a_float(one, oracle::judge(one, got))) return true;
  const std::vector<double> numbers = numbers_in(got), exactly = numbers_in(exact);
  if (numbers.empty() || numbers.size() > exactly.size()) return std::nullopt;
  double worst = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i] != exactly[i])
      worst = std::max(worst, std::abs(numbers[i] - exactly[i]) / std::abs(exactly[i]));
  return is_of_float_rounding(one, worst, exactly);
}

std::optional<bool> coordinates_right_to_float(const Case& one, const Answer& got, const Answer& exact) {
  const auto *found = std::get_if<RayAnswer>(&got), *right = std::get_if<RayAnswer>(&exact);
  if (one.precision == Precision::float32 || found == nullptr || !found->barycentric || !right->barycentric)
    return std::nullopt;
  const glm::dvec3 &weights = *right->barycentric, off = glm::abs(*found->barycentric - weights);
  return is_of_float_rounding(one, std::max({off.x, off.y, off.z}),
                              std::array{weights.x, weights.y, weights.z});
}

std::optional<bool> point_right_to_float(const Case& one, const Answer& got, const Answer& exact) {
  const auto *found = std::get_if<RayAnswer>(&got), *right = std::get_if<RayAnswer>(&exact);
  if (one.precision == Precision::float32 || found == nullptr || !found->point || !right->point)
    return std::nullopt;
  const glm::dvec3 &point = *right->point, off = glm::abs(*found->point - point);
  const double size = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  if (size == 0) return std::nullopt;
  return is_of_float_rounding(one, std::max({off.x, off.y, off.z}) / size,
                              std::array{point.x, point.y, point.z});
}

std::optional<bool> is_of_half(const Case& /*one*/, const Answer& got, const Answer& exact) {
  return if_short(got, exact, [](double x) {
    constexpr double smallest = 0x1p-24, largest = 65504;  // a subnormal's step; the largest of float16
    if (x == 0 || !std::isfinite(x)) return true;
    const double step = std::max(smallest, std::ldexp(1.0, std::ilogb(x) - 10));
    return std::abs(x) <= largest && std::remainder(x, step) == 0;
  });
}

std::optional<bool> is_approximate(const Case& one, const Answer& got, const Answer& exact) {
  const std::vector<double> numbers = numbers_in(got);
  std::vector<double> exactly = numbers_in(exact);
  if (numbers.empty() || numbers.size() > exactly.size()) return std::nullopt;
  exactly.resize(numbers.size());  // of a subject that gives the nearest hit alone
  const double best = one.precision == Precision::float32 ? 0x1p-19 : 0x1p-24, worst = 0x1p-6;
  return std::ranges::equal(numbers, exactly, [&](double x, double y) {
    const double error = std::abs(x - y);
    return best * std::abs(y) <= error && error <= worst * std::abs(y);
  });
}

std::optional<bool> has_approximate_root(const Case& one, const Answer& got, const Answer& exact) {
  const RayQuestion* asked = ray_question(one);
  const std::optional<double> error = asked == nullptr ? std::nullopt : largest_error(got, exact);
  if (!error) return std::nullopt;
  const HitList line = hits_of_line(one).hits;
  if (line.count < 2) return std::nullopt;
  const double half = (line.t[1] - line.t[0]) / 2;
  const double worst = *error / half;
  // The textbook's discriminant loses this much of its root by rounding.
  const double far = 1 + size_of_scene(one) / (glm::length(asked->ray.direction) * half);
  const double rounding = (one.precision == Precision::float32 ? 0x1p-20 : 0x1p-48) * far * far;
  if (worst > 0x1p-5) return false;
  return worst > std::max(0x1p-17, rounding) ? std::optional(true) : std::nullopt;
}

std::optional<bool> is_off_by_a_share(const Case& one, const Answer& got, const Answer& exact) {
  const RayQuestion* asked = ray_question(one);
  const auto* ray = std::get_if<RayAnswer>(&got);
  if (asked == nullptr || ray == nullptr || ray->verdict_only) return std::nullopt;
  const bool is_float = one.precision == Precision::float32;
  constexpr double largest = 0x1p-5;
  if (!std::ranges::all_of(numbers_in(got), [](double t) { return std::isfinite(t); })) return false;
  const oracle::Judgement judgement = oracle::judge(one, got);
  if (judgement.wrong) return judgement.margin * roundoff_of(one.precision) < largest;
  const std::optional<double> error = largest_error(got, exact);
  const std::vector<double> numbers = numbers_in(exact);
  if (!error || numbers.front() == 0) return std::nullopt;
  if (*error <= (is_float ? 0x1p-22 : 0x1p-45) * std::abs(numbers.front())) return false;
  const double share = *error * glm::length(asked->ray.direction) / size_of_scene(one);
  if (share > largest) return false;
  return share > (is_float ? 0x1p-18 : 0x1p-24) ? std::optional(true) : std::nullopt;
}

std::optional<bool> is_right_to_length(const Case& one, const Answer& got, const Answer& exact,
                                       double length) {
  const RayQuestion* asked = ray_question(one);
  const std::optional<double> error = asked == nullptr ? std::nullopt : largest_error(got, exact);
  if (!error) return std::nullopt;
  const double worst = *error * glm::length(asked->ray.direction);
  if (worst > 1.5 * length) return false;
  const double of_float = 0x1p-16 * size_of_scene(one);  // which a double may have on its way, too
  return worst > std::max(length / 1024, of_float) ? std::optional(true) : std::nullopt;
}

std::optional<bool> has_six_digits(const Case& /*one*/, const Answer& got, const Answer& exact) {
  return if_short(got, exact,
                  [](double x) { return std::strtod(fmt::format("{:.6g}", x).c_str(), nullptr) == x; });
}

std::optional<bool> has_six_decimals(const Case& /*one*/, const Answer& got, const Answer& exact) {
  return if_short(got, exact, [](double x) {
    return !std::isfinite(x) || std::abs(x) > 0x1p52 ||
           std::strtod(fmt::format("{:.6f}", x).c_str(), nullptr) == x;
  });
}

std::optional<bool> has_whole_numbers(const Case& /*one*/, const Answer& got, const Answer& exact) {
  return if_short(got, exact, [](double x) { return !std::isfinite(x) || std::trunc(x) == x; });
}

}  // namespace rayproof::diagnosis
