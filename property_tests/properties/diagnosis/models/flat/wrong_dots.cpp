#include "properties/diagnosis/models/flat/wrong_dots.hpp"

#include <array>

#include "properties/diagnosis/models/flat/weights.hpp"

namespace rayproof::diagnosis {
namespace {

/// e·e, e·f, f·f, w·e, w·f.
using Dots = std::array<double, 5>;

/// Which of the dot products stand in the two weights and in the determinant: each ab - cd, or ab + cd.
struct Formula {
  std::array<std::size_t, 12> factors{2, 3, 1, 4, 0, 4, 1, 3, 0, 2, 1, 1};
  std::array<double, 3> signs{-1, -1, -1};
};

double value_of(const Formula& formula, std::size_t part, const Dots& dots) {
  const auto factor = [&](std::size_t i) { return dots.at(formula.factors.at(4 * part + i)); };
  return factor(0) * factor(1) + formula.signs.at(part) * factor(2) * factor(3);
}

/// Every formula with one mistake in it.
std::vector<Formula> mistaken_formulas() {
  std::vector<Formula> all;
  const Formula right;
  for (std::size_t i = 0; i < right.factors.size(); ++i)
    for (std::size_t other = 0; other < 5; ++other) {
      Formula wrong;
      wrong.factors.at(i) = other;
      if (other != right.factors.at(i)) all.push_back(wrong);
    }
  for (std::size_t part = 0; part < 3; ++part) {
    Formula wrong;
    wrong.signs.at(part) = 1;
    all.push_back(wrong);
  }
  return all;
}

}  // namespace

Answers wrong_dots(const Case& one, const Answer& /*exact*/) {
  static const std::vector<Formula> formulas = mistaken_formulas();
  const auto right = triangle_hit(one);
  if (!right) return {};
  const auto& triangle = *shape_in<Triangle<double>>(one);
  const glm::dvec3 e = triangle.b - triangle.a, f = triangle.c - triangle.a,
                   w = point_at(ray_in_object(*ray_question(one)), right->t) - triangle.a;
  const Dots dots{glm::dot(e, e), glm::dot(e, f), glm::dot(f, f), glm::dot(w, e), glm::dot(w, f)};
  Answers answers;
  for (const Formula& formula : formulas) {
    TriangleHit hit = *right;
    const double determinant = value_of(formula, 2, dots);
    hit.beta = value_of(formula, 0, dots) / determinant;
    hit.gamma = value_of(formula, 1, dots) / determinant;
    answers.push_back(by_weights(one, hit).front());
  }
  return answers;
}

}  // namespace rayproof::diagnosis
