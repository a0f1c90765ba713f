#include "properties/diagnosis/models/curved/small_discriminant.hpp"

#include <algorithm>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/curved/root_formula.hpp"

namespace rayproof::diagnosis {
namespace {

/// The discriminant in the forms of textbooks: b² - 4ac, (b/2)² - ac, and of a ray also that of the direction
/// made a unit vector.
std::vector<double> discriminants(const Case& one, const ReducedEquation& equation) {
  const double D = equation.discriminant();
  if (ray_question(one) == nullptr) return {4 * D, D};
  return {4 * D, D, D / equation.a, 4 * D / equation.a};
}

/// How many of them are below the limit in size: some, all or none.
enum class Below { none, some, all };

Below below(const Case& one, const ReducedEquation& equation, double limit) {
  const std::vector<double> all = discriminants(one, equation);
  const auto is_below = [limit](double D) { return std::abs(D) < limit; };
  if (std::ranges::all_of(all, is_below)) return Below::all;
  return std::ranges::any_of(all, is_below) ? Below::some : Below::none;
}

Answers taken_for_zero(const Case& one, const ReducedEquation& equation) {
  const double x = -equation.h / equation.a;
  Answers answers = with_roots(one, std::array{x, x});
  auto* ray = std::get_if<RayAnswer>(&answers.front());
  if (ray != nullptr && ray->hits.count == 2 && ray->hits.t[0] == ray->hits.t[1]) ray->hits.count = 1;
  return answers;
}

}  // namespace

Answers small_discriminant(const Case& one, const Answer& exact, double limit) {
  const auto equation = reduced_equation(one);
  if (!equation || equation->discriminant() == 0) return {};
  if (equation->discriminant() < 0) {  // |D| may be compared, or D
    Answers answers = negative_discriminant(one, exact, limit);
    if (!answers.empty()) answers.push_back(exact);
    return answers;
  }
  const Below is_small = below(one, *equation, limit);
  if (is_small == Below::none) return {};
  Answers answers = with_roots(one, std::nullopt);
  for (Answer& answer : taken_for_zero(one, *equation)) answers.push_back(std::move(answer));
  if (is_small == Below::some) answers.push_back(exact);
  return answers;
}

Answers called_tangent_below(const Case& one, const Answer& exact, double limit) {
  const auto equation = reduced_equation(one);
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (!equation || answer == nullptr || answer->contact != Contact::crossing) return {};
  const Below is_small = below(one, *equation, limit);
  if (is_small == Below::none) return {};
  RayAnswer tangent = *answer;
  tangent.contact = Contact::tangent;
  return is_small == Below::some ? Answers{tangent, exact} : Answers{tangent};
}

Answers nearly_double_root(const Case& one, const Answer& exact, double share) {
  const auto equation = reduced_equation(one);
  if (!equation || equation->a == 0) return {};
  const double D = equation->discriminant();
  if (D == 0 || !(std::abs(D) < share * equation->h * equation->h)) return {};
  Answers answers = taken_for_zero(one, *equation);
  if (D < 0) answers.push_back(exact);
  return answers;
}

Answers negative_discriminant(const Case& one, const Answer& exact, double limit) {
  const auto equation = reduced_equation(one);
  if (!equation || !(equation->discriminant() < 0)) return {};
  const Below is_small = below(one, *equation, limit);
  if (is_small == Below::none) return {};
  Answers answers = taken_for_zero(one, *equation);
  if (is_small == Below::some) answers.push_back(exact);
  return answers;
}

}  // namespace rayproof::diagnosis
