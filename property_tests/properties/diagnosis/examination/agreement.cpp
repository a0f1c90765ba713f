#include "properties/diagnosis/examination/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/changes.hpp"

namespace rayproof::diagnosis {
namespace {

/// t is found to about this: what rounding the lengths of the scene does to it.
double scale_of_t(const Case& one) {
  const RayQuestion* asked = ray_question(one);
  return asked == nullptr ? 0 : size_of_scene(one) / glm::length(asked->ray.direction);
}

bool agree_in_hits(const Case& one, const RayAnswer& got, const RayAnswer& other) {
  const std::size_t wanted = got.nearest_only ? std::min<std::size_t>(other.hits.count, 1) : other.hits.count;
  if (got.hits.count != wanted) return false;
  if (got.verdict_only) return true;
  const double scale = scale_of_t(one);
  for (std::size_t i = 0; i < wanted; ++i)
    if (!are_close(one.precision, got.hits.t.at(i), other.hits.t.at(i), scale)) return false;
  return true;
}

bool agree_in_vector(const std::optional<glm::dvec3>& got, const std::optional<glm::dvec3>& other,
                     double scale) {
  if (!got || !other) return got.has_value() == other.has_value();
  return glm::length(*got - *other) <= 0x1p-10 * std::max(scale, glm::length(*other));
}

bool agree_in_numbers(const Case& one, const Answer& got, const Answer& other) {
  if (const auto* position = std::get_if<Position>(&got)) return *position == std::get<Position>(other);
  const std::vector<double> a = numbers_in(got), b = numbers_in(other);
  return std::get<QuadraticAnswer<double>>(got).kind == std::get<QuadraticAnswer<double>>(other).kind &&
         std::ranges::equal(a, b, [&](double x, double y) { return are_close(one.precision, x, y, 0); });
}

}  // namespace

Answer as_reported(const Answer& predicted, const Answer& got) {
  Answer reported = predicted;
  // Who does not say the kind of a single root is taken to say that it is a double one.
  const auto* roots = std::get_if<QuadraticAnswer<double>>(&got);
  auto* other = std::get_if<QuadraticAnswer<double>>(&reported);
  const bool is_of_linear = other != nullptr && other->kind == RootKind::linear;
  if (is_of_linear && roots != nullptr && roots->kind == RootKind::twice) other->kind = roots->kind;
  const auto* mine = std::get_if<RayAnswer>(&got);
  auto* ray = std::get_if<RayAnswer>(&reported);
  if (ray == nullptr || mine == nullptr) return reported;
  ray->verdict_only = mine->verdict_only;
  if (mine->nearest_only) ray->hits.count = std::min<std::size_t>(ray->hits.count, 1);
  return reported;
}

bool are_close(Precision precision, double x, double y, double scale) {
  if (x == y) return true;
  const double rounding = precision == Precision::float32 ? 0x1p-18 : 0x1p-40;
  return std::abs(x - y) <= 0x1p-10 * std::abs(y) + rounding * scale;
}

bool is_nearer_to(const Case& one, const Answer& got, const Answer& other, const Answer& exact) {
  constexpr double clearly = 16;
  const auto* mine = std::get_if<RayAnswer>(&got);
  if (mine == nullptr || mine->verdict_only) return false;
  const std::vector<double> a = numbers_in(got), b = numbers_in(other), c = numbers_in(exact);
  if (a.empty() || a.size() != b.size() || a.size() != c.size()) return false;
  const double rounding = (one.precision == Precision::float32 ? 0x1p-18 : 0x1p-40) * scale_of_t(one);
  double from_other = rounding, from_exact = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    from_other = std::max(from_other, std::abs(a[i] - b[i]));
    from_exact = std::max(from_exact, std::abs(a[i] - c[i]));
    // A number is not near another one only because both are small.
    if (clearly * std::abs(a[i] - b[i]) > std::abs(b[i]) + clearly * rounding) return false;
  }
  return clearly * from_other < from_exact;
}

std::optional<Aspect> detail_of(Claim claim) {
  if (claim == Claim::point) return Aspect::point;
  if (claim == Claim::normal) return Aspect::normal;
  if (claim == Claim::coordinates) return Aspect::coordinates;
  return std::nullopt;
}

bool says_detail(const Case& one, Answer& answer, Aspect detail) {
  auto* ray = std::get_if<RayAnswer>(&answer);
  if (ray == nullptr || ray->hits.count == 0) return false;
  if (detail == Aspect::point && !ray->point) ray->point = point_at(ray_question(one)->ray, ray->hits.t[0]);
  if (detail == Aspect::point) return ray->point.has_value();
  return detail == Aspect::normal ? ray->normal.has_value() : ray->barycentric.has_value();
}

bool agree(const Case& one, const Answer& got, const Answer& other, Aspect aspect) {
  const auto* a = std::get_if<RayAnswer>(&got);
  const auto* b = std::get_if<RayAnswer>(&other);
  if (got.index() != other.index()) return false;
  if (a == nullptr) return agree_in_numbers(one, got, other);
  switch (aspect) {
    case Aspect::hits:
      return agree_in_hits(one, *a, *b);
    case Aspect::contact:
      return a->contact == b->contact;
    case Aspect::point:
      return agree_in_vector(a->point, b->point, size_of_scene(one));
    case Aspect::normal:
      return agree_in_vector(a->normal, b->normal, 1);
    case Aspect::coordinates:
      return agree_in_vector(a->barycentric, b->barycentric, 1);
  }
  return false;
}

}  // namespace rayproof::diagnosis
