/// \file
/// Properties every subject claims, however bad its formula: order, NaN, and batch equals scalar.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "properties/boundary.hpp"
#include "properties/claims/answers.hpp"
#include "properties/claims/promise.hpp"
#include "properties/numbers.hpp"
#include "properties/property.hpp"

namespace rayproof {

namespace {

/// Whether the middle between two hits, or roots, is one, too, as far as the promised residual can say: a ray
/// that runs almost along a face meets it anywhere there.
bool is_met_between(Trial& trial, Answer exact) {
  const auto to_the_middle = [](double& first, double second) { first = std::midpoint(first, second); };
  if (auto* of_ray = std::get_if<RayAnswer>(&exact)) to_the_middle(of_ray->hits.t[0], of_ray->hits.t[1]);
  if (auto* of_equation = std::get_if<QuadraticAnswer<double>>(&exact))
    to_the_middle(of_equation->roots[0], of_equation->roots[1]);
  return oracle::judge(trial.question(), exact).residual <= residual_or_robust(trial);
}

/// Whether one of two hits, or roots, is given for both, though they are so far apart that no plain method's
/// discriminant merges them. An ill-conditioned transform may, so that a case with one is not looked at.
bool gives_one_twice(Trial& trial) {
  constexpr double alike = 0x1p-12, merging = 0x1p12;
  const auto* asked = std::get_if<RayQuestion>(&trial.question().question);
  if (asked != nullptr && asked->transform) return false;
  const std::vector<double> given = numbers_in(trial.claimed());
  if (given.size() != 2 || !trial.in_domain()) return false;
  const double size = std::max(std::abs(given[0]), std::abs(given[1]));
  if (!std::isfinite(size) || std::abs(given[1] - given[0]) > alike * size) return false;
  const Answer answer = oracle::answer(trial.question());
  const std::vector<double> exact = numbers_in(answer);
  if (exact.size() != 2) return false;
  const double apart = (exact[1] - exact[0]) / std::max(std::abs(exact[0]), std::abs(exact[1]));
  const double unit = roundoff_of(trial.question().precision);
  const double far = trial.judgement().far;
  return apart > 4 * alike && apart * apart > merging * unit * far * far && !is_met_between(trial, answer);
}

/// Whether t lies in the interval, whose ends belong to it. Of a guest also where it lies beyond by its
/// rounding alone: it may have compared other numbers with the ends, t·|d| say, or write t with just as many
/// digits as distinguish two floats.
bool is_in_interval(const Trial& trial, const Ray<double>& ray, double t) {
  constexpr double few = 8;
  const double doubt = trial.subject().has_own_contract ? 0 : few * roundoff_of(trial.question().precision);
  const auto is_beyond = [&](double past, double end) {
    return past > 0 && !(std::isfinite(end) && past <= doubt * std::abs(end));
  };
  return !is_beyond(ray.t_min - t, ray.t_min) && !is_beyond(t - ray.t_max, ray.t_max);
}

Ruling ascending(Trial& trial) {
  if (!gives_numbers(trial.claimed())) return Ruling::outside;
  const std::vector<double> numbers = numbers_in(trial.claimed());
  const auto* asked = std::get_if<RayQuestion>(&trial.question().question);
  const bool all_count = std::ranges::all_of(numbers, [&](double x) {
    return !std::isnan(x) && (asked == nullptr || is_in_interval(trial, asked->ray, x));
  });
  const bool is_right = all_count && std::ranges::is_sorted(numbers) && !gives_one_twice(trial);
  return is_right ? Ruling::held : Ruling::broken;
}

/// Whether an equation is said to have two roots or a double one, be they numbers or not.
bool claims_roots(const Answer& answer) {
  const auto* roots = std::get_if<QuadraticAnswer<double>>(&answer);
  return roots != nullptr && (roots->kind == RootKind::two || roots->kind == RootKind::twice);
}

/// Every how many numbers of a case one is made NaN: of an outline of very many vertices not each, since each
/// takes an answer that reads them all; x, y and z in turn.
std::size_t step_of_nan(std::size_t numbers) {
  constexpr std::size_t most = 1024;
  std::size_t step = 1 + numbers / most;
  while (step % 2 == 0 || step % 3 == 0) ++step;
  return step;
}

/// The number of the case that gives a hit when it becomes NaN, and that answer; nothing where none does.
std::optional<std::pair<CaseNumber, Answer>> hit_from_nan(Trial& trial) {
  Case spoilt = trial.question();
  const std::vector<CaseNumber> numbers = numbers_of(spoilt);
  const std::size_t step = step_of_nan(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); i += i < 32 ? 1 : step) {
    const CaseNumber& number = numbers[i];
    const double kept = *number.value;
    *number.value = std::numeric_limits<double>::quiet_NaN();
    const Answer answer = trial.subject().answer(spoilt);
    *number.value = kept;
    if (finds_something(answer) || claims_roots(answer)) return std::pair{number, answer};
  }
  return std::nullopt;
}

Ruling nan(Trial& trial) { return hit_from_nan(trial) ? Ruling::broken : Ruling::held; }

Evidence show_nan(Trial& trial) {
  const auto found = hit_from_nan(trial);
  if (!found) return show_answer(trial, "");
  Evidence evidence{found->second, oracle::answer(trial.question()), {}, {}};
  evidence.note = fmt::format("got is the answer with NaN in {}", found->first.field);
  return evidence;
}

/// Asked of the whole line: where the interval ends is no matter of the shape.
Answer on_line(Trial& trial) { return trial.subject().answer(on_whole_line(trial.question())); }

Ruling conservative(Trial& trial) {
  const bool sees_case = !is_transformed(trial.question()) || trial.subject().takes_transforms;
  if (!sees_case || !trial.in_domain() || !finds_something(oracle::answer(on_whole_line(trial.question()))))
    return Ruling::outside;
  return finds_something(on_line(trial)) ? Ruling::held : Ruling::broken;
}

Ruling batch(Trial& trial) {
  if (trial.subject().answer_in_batch == nullptr) return Ruling::outside;
  const Answer answer = trial.subject().answer_in_batch(trial.question());
  return same(answer, trial.claimed()) ? Ruling::held : Ruling::broken;
}

Evidence show_batch(Trial& trial) {
  return show_answer(trial.question(), trial.subject().answer_in_batch(trial.question()),
                     "got is the batch's answer; one ray at a time the method answers otherwise");
}

/// Whether a triangle's area may be rounded to 0: so much of the product of two edges cancels.
bool is_nearly_flat(const Case& one) {
  constexpr double few = 16;
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  const auto* triangle = asked == nullptr ? nullptr : std::get_if<Triangle<double>>(&asked->shape);
  if (triangle == nullptr) return false;
  const glm::dvec3 e1 = triangle->b - triangle->a, e2 = triangle->c - triangle->a;
  return glm::length(glm::cross(e1, e2)) <=
         few * roundoff_of(one.precision) * glm::length(e1) * glm::length(e2);
}

/// Of misses alone: where a hit is claimed or missed, that is the verdict's property. What a guest rounds may
/// turn a ray along the plane by an ulp: its reasons are judged where a plain method rounds nothing.
Ruling contact(Trial& trial) {
  if (trial.judgement().wrong || trial.judgement().hit) return Ruling::outside;
  const auto* claimed = std::get_if<RayAnswer>(&trial.claimed());
  if (claimed == nullptr || !claimed->says_contact) return Ruling::outside;
  const Answer exact = oracle::answer(trial.question());
  if (claimed->contact == std::get<RayAnswer>(exact).contact) return Ruling::held;
  const bool may_round = !trial.subject().has_own_contract && !is_exact_for_some_method(trial.question());
  const bool may_be_none = !trial.subject().has_own_contract && claimed->contact == Contact::degenerate &&
                           is_nearly_flat(trial.question());
  return may_round || may_be_none ? Ruling::outside : Ruling::broken;
}

}  // namespace

std::vector<Property> safety_properties() {
  return {
      {Claim::contact, "contact",
       "the reason why a ray misses is right: parallel, inside the surface, or neither", 1, contact,
       [](Trial& trial) {
         return show_answer(trial, "the ray misses, but not for the reason that is given");
       }},
      {Claim::ascending, "ascending",
       "hits come in ascending order, inside the interval, each once, none of them NaN", 1, ascending,
       [](Trial& trial) {
         return show_answer(trial, gives_one_twice(trial)
                                       ? "one hit is given twice, and the other is not"
                                       : "a hit is out of order, outside the interval, or NaN");
       }},
      {Claim::conservative, "conservative", "a line that meets the shape is never said to miss it", 1,
       conservative,
       [](Trial& trial) {
         return show_answer(on_whole_line(trial.question()), on_line(trial), "the line meets the shape");
       }},
      {Claim::batch, "batch", "a batch gives bit for bit the scalar answers", 4, batch, show_batch},
      {Claim::nan, "nan", "a NaN anywhere in the input never gives a hit", 128, nan, show_nan},
  };
}

}  // namespace rayproof
