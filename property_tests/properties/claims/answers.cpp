#include "properties/claims/answers.hpp"

#include <algorithm>
#include <cmath>

namespace rayproof {

std::vector<double> numbers_in(const Answer& answer) {
  if (const auto* hits = std::get_if<RayAnswer>(&answer)) {
    const auto view = hits->hits.view();
    return {view.begin(), view.end()};
  }
  if (std::holds_alternative<Position>(answer)) return {};
  const auto& roots = std::get<QuadraticAnswer<double>>(answer);
  return {roots.roots.begin(), roots.roots.begin() + static_cast<std::ptrdiff_t>(roots.count)};
}

bool finds_something(const Answer& answer) {
  if (const auto* position = std::get_if<Position>(&answer)) return *position != Position::outside;
  return !numbers_in(answer).empty();
}

bool gives_numbers(const Answer& answer) {
  const auto* hits = std::get_if<RayAnswer>(&answer);
  return hits == nullptr || !hits->verdict_only;
}

bool same(const Answer& a, const Answer& b) {
  if (a.index() != b.index()) return false;
  if (const auto* position = std::get_if<Position>(&a)) return *position == std::get<Position>(b);
  const auto* roots = std::get_if<QuadraticAnswer<double>>(&a);
  if (roots != nullptr && roots->kind != std::get<QuadraticAnswer<double>>(b).kind) return false;
  return std::ranges::equal(numbers_in(a), numbers_in(b),
                            [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

Answer stretched(const Answer& answer, double factor) {
  if (std::holds_alternative<Position>(answer)) return answer;  // a place has no length
  std::vector<double> numbers = numbers_in(answer);
  for (double& x : numbers) x *= factor;
  if (factor < 0) std::reverse(numbers.begin(), numbers.end());
  if (const auto* ray = std::get_if<RayAnswer>(&answer)) {
    RayAnswer result;
    result.contact = ray->contact;
    for (const double t : numbers) result.hits.push_back(t);
    return result;
  }
  auto result = std::get<QuadraticAnswer<double>>(answer);
  std::copy(numbers.begin(), numbers.end(), result.roots.begin());
  return result;
}

}  // namespace rayproof
