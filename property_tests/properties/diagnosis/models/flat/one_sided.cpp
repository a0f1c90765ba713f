#include "properties/diagnosis/models/flat/one_sided.hpp"

#include <algorithm>
#include <cmath>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/flat/flat.hpp"

namespace rayproof::diagnosis {
namespace {

constexpr int largest_power = -2, least_power = -15;

bool is_small(double number) { return 0 < number && number < std::pow(10.0, largest_power); }

/// A miss where the number is below the limit, for each limit; nothing where it is below none.
Answers missed_below(double number, const Answer& exact) {
  Answers answers;
  for (int power = largest_power; power >= least_power; --power)
    answers.push_back(number < std::pow(10.0, power) ? Answer{RayAnswer{}} : exact);
  return number < std::pow(10.0, largest_power) ? answers : Answers{};
}

std::optional<double> volume_of(const Case& one) {
  const auto* solid = shape_in<Parallelepiped<double>>(one);
  if (solid == nullptr) return std::nullopt;
  const auto& [u, v, w] = solid->edges;
  return glm::dot(u, glm::cross(v, w));
}

}  // namespace

Answers slope_without_abs(const Case& one, const Answer& exact, double sign) {
  const std::optional<double> slope = finds_something(exact) ? slope_of_surface(one) : std::nullopt;
  return slope ? missed_below(sign * *slope, exact) : Answers{};
}

bool has_small_slope(const Case& one, double sign) {
  const std::optional<double> slope = slope_of_surface(one);
  return slope && is_small(sign * *slope);
}

Answers volume_without_abs(const Case& one, const Answer& exact) {
  const std::optional<double> volume = finds_something(exact) ? volume_of(one) : std::nullopt;
  return volume ? missed_below(*volume, exact) : Answers{};
}

bool has_small_volume(const Case& one, const Answer& /*exact*/) {
  const std::optional<double> volume = volume_of(one);
  return volume && is_small(*volume);
}

}  // namespace rayproof::diagnosis
