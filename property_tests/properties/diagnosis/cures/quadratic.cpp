#include <cmath>

#include "properties/diagnosis/cures/cures.hpp"

namespace rayproof::diagnosis {
namespace {

template <class DoChange>
Cases with_equation(const Case& one, DoChange&& change) {
  Case changed = one;
  auto* equation = std::get_if<Quadratic<double>>(&changed.question);
  if (equation == nullptr || equation->a == 0 || !change(*equation)) return {};
  return if_valid(std::move(changed));
}

}  // namespace

Cases positive_a(const Case& one) {
  return with_equation(one, [](Quadratic<double>& q) {
    if (q.a > 0) return false;
    q = {-q.a, -q.b, -q.c};
    return true;
  });
}

Cases leading_one(const Case& one) {
  return with_equation(one, [](Quadratic<double>& q) {
    const double a = q.a;
    q = {1, q.b / a, q.c / a};
    return a != 1;
  });
}

Cases small_b(const Case& one) {
  return with_equation(one, [](Quadratic<double>& q) {
    const double wanted = std::sqrt(16 * std::abs(q.a) * std::abs(q.c));
    if (std::abs(q.b) <= wanted) return false;
    q.b = std::copysign(wanted, q.b);
    return true;
  });
}

}  // namespace rayproof::diagnosis
