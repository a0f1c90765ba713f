#include <algorithm>
#include <cmath>

#include "properties/claims/similarity.hpp"
#include "properties/diagnosis/cures/cures.hpp"

namespace rayproof::diagnosis {
namespace {

/// Whether both have the same numbers.
bool have_same_numbers(Case one, Case other) {
  return std::ranges::equal(
      numbers_of(one), numbers_of(other), {}, [](const CaseNumber& x) { return *x.value; },
      [](const CaseNumber& x) { return *x.value; });
}

/// The case with its lengths and its direction (or its equation) times 2^steps, for each number of steps that
/// loses no digits: a shape of which all is rounded to 0 is another question.
Cases scaled_cases(const Case& one, std::initializer_list<int> steps, bool are_lengths) {
  Cases all;
  for (const int step : steps) {
    const double factor = std::ldexp(1.0, step);
    const Twin twin = are_lengths ? scaled_twin(one, factor, 1) : scaled_twin(one, 1, factor);
    for (Case& valid : if_valid(twin.one))
      if (have_same_numbers(twin.one, valid)) all.push_back(std::move(valid));
  }
  return all;
}

int exponent_of(double size) { return size > 0 && std::isfinite(size) ? std::ilogb(size) : 0; }

/// The largest number among those of the shape, without the place of the ray.
double size_of_shape(Case one) {
  double size = 0;
  for (const CaseNumber& number : numbers_of(one))
    if (!number.field.starts_with("ray.") && number.field != "normal" && number.field != "transform")
      size = std::max(size, std::abs(*number.value));
  return size;
}

}  // namespace

Cases larger_scene(const Case& one) { return scaled_cases(one, {10, 20, 40, 100, 200}, true); }
Cases smaller_scene(const Case& one) { return scaled_cases(one, {-10, -20, -40, -100, -200}, true); }
Cases longer_direction(const Case& one) {
  constexpr double long_enough = 0x1p20;  // no product with it is small
  const RayQuestion* asked = ray_question(one);
  if (asked != nullptr && glm::length(asked->ray.direction) > long_enough) return {};
  return scaled_cases(one, {10, 20, 40, 100, 200}, false);
}
Cases shorter_direction(const Case& one) { return scaled_cases(one, {-10, -20, -40, -100, -200}, false); }

Cases ordinary_sizes(const Case& one) {
  if (std::holds_alternative<PointAndPolygon<double>>(one.question)) return {};
  const int lengths = -exponent_of(size_of_shape(one));
  if (const auto* q = std::get_if<Quadratic<double>>(&one.question)) {
    const int largest = exponent_of(std::max({std::abs(q->a), std::abs(q->b), std::abs(q->c)}));
    return largest == 0 ? Cases{} : if_valid(scaled_twin(one, 1, std::ldexp(1.0, -largest)).one);
  }
  const int whole = -exponent_of(glm::length(ray_question(one)->ray.direction));
  if (lengths == 0 && whole == 0) return {};
  return if_valid(scaled_twin(one, std::ldexp(1.0, lengths), std::ldexp(1.0, whole)).one);
}

}  // namespace rayproof::diagnosis
