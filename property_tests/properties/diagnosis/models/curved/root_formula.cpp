#include "properties/diagnosis/models/curved/root_formula.hpp"

#include <algorithm>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/cylinder_parts.hpp"

namespace rayproof::diagnosis {
namespace {

ReducedEquation of_sphere(const Ray<double>& ray, const Sphere<double>& sphere) {
  const glm::dvec3 way = ray.origin - sphere.center;
  return {glm::dot(ray.direction, ray.direction), glm::dot(way, ray.direction),
          glm::dot(way, way) - sphere.radius * sphere.radius};
}

ReducedEquation of_side(const Ray<double>& ray, const Cylinder<double>& cylinder) {
  const glm::dvec2 radii(cylinder.rx, cylinder.ry);
  const glm::dvec2 o = glm::dvec2(ray.origin) / radii, d = glm::dvec2(ray.direction) / radii;
  return {glm::dot(d, d), glm::dot(o, d), glm::dot(o, o) - 1};
}

/// The equation of the case, a 0 or not; nothing where it has none.
std::optional<ReducedEquation> equation_of(const Case& one) {
  if (const auto* q = std::get_if<Quadratic<double>>(&one.question))
    return ReducedEquation{q->a, q->b / 2, q->c};
  if (const auto* sphere = shape_in<Sphere<double>>(one))
    return of_sphere(ray_in_object(*ray_question(one)), *sphere);
  if (const auto* cylinder = shape_in<Cylinder<double>>(one))
    return of_side(ray_in_object(*ray_question(one)), *cylinder);
  return std::nullopt;
}

Answers of_equation(const FoundRoots& roots) {
  using Roots = QuadraticAnswer<double>;
  if (!roots) return {Roots{RootKind::none, 0, {}}};
  const auto [x, y] = *roots;
  if (x == y)
    return {Roots{RootKind::twice, 1, {x}}, Roots{RootKind::two, 2, {x, x}}, Roots{RootKind::two, 1, {x}}};
  Answers answers{Roots{RootKind::two, 2, {std::min(x, y), std::max(x, y)}}};
  if (x > y) answers.emplace_back(Roots{RootKind::two, 2, {x, y}});
  return answers;
}

/// Two numbers of the answer and two of the exact one; nothing where either has not two.
struct TwoPairs {
  double x, y, exact_x, exact_y;
  [[nodiscard]] double size() const { return std::max(std::abs(exact_x), std::abs(exact_y)); }
  /// Whether the difference is more than a loss of digits makes.
  [[nodiscard]] bool differ(double a, double b) const {
    return !std::isfinite(a) || std::abs(a - b) > 0x1p-10 * std::max(size(), std::abs(a));
  }
};

std::optional<TwoPairs> two_pairs(const Case& one, const Answer& got, const Answer& exact) {
  if (!reduced_equation(one) || shape_in<Cylinder<double>>(one) != nullptr) return std::nullopt;
  const std::vector<double> found = numbers_in(got), right = numbers_in(exact);
  if (found.size() != 2 || right.size() != 2) return std::nullopt;
  return TwoPairs{found[0], found[1], right[0], right[1]};
}

}  // namespace

std::optional<ReducedEquation> reduced_equation(const Case& one) {
  const std::optional<ReducedEquation> equation = equation_of(one);
  return equation && equation->a != 0 ? equation : std::nullopt;
}

Answers with_roots(const Case& one, const FoundRoots& roots) {
  if (std::holds_alternative<Quadratic<double>>(one.question)) return of_equation(roots);
  std::vector<double> hits;
  if (roots) hits.assign(roots->begin(), roots->end());
  if (shape_in<Cylinder<double>>(one) != nullptr) return with_side_hits(one, std::move(hits));
  const auto admitted = [&] {
    RayAnswer line;
    for (const double t : hits)
      if (in_interval(ray_question(one)->ray, t)) line.hits.push_back(t);
    return line;
  };
  Answers answers{admitted()};
  if (std::ranges::is_sorted(hits)) return answers;
  std::ranges::sort(hits);
  answers.emplace_back(admitted());
  return answers;
}

Answers a_taken_for_one(const Case& one, const Answer& exact) {
  const auto equation = equation_of(one);
  const bool is_ray_along_axis = equation && equation->a == 0 && ray_question(one) != nullptr;
  if (!equation || shape_in<Sphere<double>>(one) != nullptr) return {};
  if (equation->a == 0 && !is_ray_along_axis) return {};
  Answers answers = with_roots(one, roots_by(-equation->h, equation->h * equation->h - equation->c, 1));
  if (is_ray_along_axis) answers.push_back(exact);  // which may be handled before
  return answers;
}

std::optional<bool> divides_by_what_cancels(const Case& one, const Answer& got, const Answer& exact) {
  constexpr double few = 64, clearly = 4;
  const auto pairs = two_pairs(one, got, exact);
  const auto equation = reduced_equation(one);
  if (!pairs || !(std::abs(equation->a) > 0)) return std::nullopt;
  const auto [x, y, p, q] = *pairs;
  const double size = pairs->size(), unit = roundoff_of(one.precision);
  const double off_in_sum = std::abs((x + y) - (p + q)), off_in_product = std::abs(x * y - p * q);
  if (!(off_in_sum > few * unit * size)) return std::nullopt;
  // c is a difference of squares, whose rounding the product bears.
  const double squares = size * size + std::abs(equation->h * equation->h / (equation->a * equation->a));
  // Cancellation loses no more: else a wrong number divides, or a sign is wrong.
  const double most_lost = few * unit * squares / std::min(std::abs(p), std::abs(q));
  if (off_in_sum > most_lost || !(x * p > 0)) return false;
  return off_in_product <= few * unit * squares && clearly * off_in_product < off_in_sum * size;
}

std::optional<bool> one_root_wrong(const Case& one, const Answer& got, const Answer& exact) {
  const auto pairs = two_pairs(one, got, exact);
  if (!pairs) return std::nullopt;
  const auto is_one_of = [&](double z) {
    return !pairs->differ(z, pairs->exact_x) || !pairs->differ(z, pairs->exact_y);
  };
  const bool is_first = is_one_of(pairs->x), is_second = is_one_of(pairs->y);
  return is_first && is_second ? std::nullopt : std::optional(is_first != is_second);
}

std::optional<bool> distance_of_roots_wrong(const Case& one, const Answer& got, const Answer& exact) {
  const auto pairs = two_pairs(one, got, exact);
  if (!pairs) return std::nullopt;
  const auto [x, y, p, q] = *pairs;
  if (!pairs->differ(std::abs(y - x), q - p)) return std::nullopt;
  return !pairs->differ(x + y, p + q);
}

std::optional<bool> middle_of_roots_wrong(const Case& one, const Answer& got, const Answer& exact) {
  const auto pairs = two_pairs(one, got, exact);
  if (!pairs) return std::nullopt;
  const auto [x, y, p, q] = *pairs;
  if (!pairs->differ(x + y, p + q)) return std::nullopt;
  return !pairs->differ(std::abs(y - x), q - p);
}

}  // namespace rayproof::diagnosis
