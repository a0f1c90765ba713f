#include "properties/diagnosis/models/hits/values.hpp"

#include <algorithm>
#include <cmath>

#include "properties/claims/answers.hpp"

namespace rayproof::diagnosis {

std::optional<bool> is_infinite(const Case& one, const Answer& got, const Answer& exact) {
  constexpr double large = 0x1p40;  // beyond that something may overflow
  Case sizes = one;
  for (const CaseNumber& number : numbers_of(sizes)) {
    const double size = std::abs(*number.value);
    if (std::isfinite(size) && size != 0 && (size > large || size < 1 / large)) return std::nullopt;
  }
  const auto is_infinity = [](double x) { return std::isinf(x); };
  if (std::ranges::any_of(numbers_in(exact), is_infinity)) return std::nullopt;
  return std::ranges::any_of(numbers_in(got), is_infinity) ? std::optional(true) : std::nullopt;
}

Answers all_at_zero(const Case& one, const Answer& /*exact*/) {
  const RayQuestion* asked = ray_question(one);
  RayAnswer line;
  if (asked == nullptr || (line = hits_of_line(one)).hits.count == 0) return {};
  line.hits.t.fill(0);
  const auto admits = [&](double t) { return in_interval(asked->ray, t); };
  Answers answers{hits_where(line, admits)};
  line.hits.count = 1;  // equal ones may be given once
  answers.emplace_back(hits_where(line, admits));
  // A product that is 0 but for its rounding may lie on either side of an end.
  if (asked->ray.t_min == 0 || asked->ray.t_max == 0) answers.emplace_back(RayAnswer{});
  return answers;
}

std::optional<bool> is_all_zero(const Case& /*one*/, const Answer& got, const Answer& exact) {
  const auto is_zero = [](double x) { return x == 0; };
  const std::vector<double> numbers = numbers_in(got);
  if (numbers.empty() || std::ranges::any_of(numbers_in(exact), is_zero)) return std::nullopt;
  return std::ranges::all_of(numbers, is_zero);
}

std::optional<bool> is_nan(const Case& /*one*/, const Answer& got, const Answer& exact) {
  const auto* hits = std::get_if<RayAnswer>(&got);
  if (hits != nullptr && hits->verdict_only) return std::nullopt;  // it gives no number
  const auto is_number = [](double x) { return std::isfinite(x); };
  if (!std::ranges::all_of(numbers_in(exact), is_number)) return std::nullopt;
  return std::ranges::any_of(numbers_in(got), [](double x) { return std::isnan(x); });
}

}  // namespace rayproof::diagnosis
