/// \file
/// The judgement of what an answer says of its first hit beside t: point, normal, barycentric coordinates.

#include <algorithm>

#include "oracle/judge/normals.hpp"

namespace rayproof::oracle {
namespace {

[[nodiscard]] bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The length of what a rounding of p(t) may be off by, but for ε: |origin| + |t||direction|, and what
/// underflow loses.
Scaled size_of_point(const Ray<double>& ray, const Quotient& t, Precision precision) {
  const Scaled smallest = precision == Precision::float32 ? Scaled(1, -149) : Scaled(1, -1074);
  return norm(ray.origin) + abs(t.estimate()) * norm(ray.direction) +
         smallest / Scaled(roundoff_of(precision));
}

/// |claimed - p(t)|; a coordinate that overflows counts as off by nothing where that of p(t) does.
template <class Number>
Scaled off_point(const Ray<double>& ray, const Number& t, const glm::dvec3& claimed, Precision precision) {
  Vector<Scaled> apart{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto exact = t.affine_image(Ring(ray.origin[axis]), Ring(ray.direction[axis]));
    Scaled& gap = axis == 0 ? apart.x : axis == 1 ? apart.y : apart.z;
    if (std::isfinite(claimed[axis]))
      gap = exact.minus(claimed[axis]);
    else if (round_correctly(exact, precision) != claimed[axis])
      gap = endless();
  }
  return norm(apart);
}

/// A point of the world as the shape has it, in the scale of ObjectRay.
Vector<Ring> in_object(const ExactIntersection& exact, const glm::dvec3& point) {
  const auto own = Vector<Ring>::from(point);
  const auto& map = exact.ray().map;
  return map ? map->apply(own - map->translation) : own;
}

/// The largest error of a coordinate, and the largest where that of one beyond 1 counts in parts of it;
/// endless where one is no number.
struct ErrorOfCoordinates {
  Scaled absolute{}, relative{};
};
template <std::size_t count, class Claimed>
ErrorOfCoordinates error_of_coordinates(const std::array<Quotient, count>& exact, const Claimed& claimed) {
  ErrorOfCoordinates most;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    if (!std::isfinite(claimed[i])) return {endless(), endless()};
    const Quotient& one = exact.at(static_cast<std::size_t>(i));
    const Scaled error = abs(one.minus(claimed[i]));
    most.absolute = std::max(most.absolute, error);
    most.relative = std::max(most.relative, error / std::max(Scaled(1), abs(one.estimate())));
  }
  return most;
}

/// Whether the last two coordinates, which are those that a method computes, are the exact ones rounded once.
template <std::size_t count, class Claimed>
bool are_rounded(const std::array<Quotient, count>& exact, const Claimed& claimed, Precision precision) {
  const auto is_rounded = [&](std::size_t i) {
    return round_correctly(exact.at(i), precision) == claimed[static_cast<int>(i)];
  };
  return is_rounded(count - 2) && is_rounded(count - 1);
}

/// The judgement of one answer.
class DetailsJudge {
 public:
  DetailsJudge(const ExactIntersection& exact, Precision precision, const RayAnswer& claimed)
      : exact_(exact),
        hits_(exact.hits()),
        precision_(precision),
        claimed_(claimed),
        t_(std::isfinite(claimed.hits.t[0]) ? claimed.hits.t[0] : 0) {}

  void judge_point(Details& details) const {
    details.point = details.surface = HUGE_VAL;
    if (!claimed_.point) return;
    const Ray<double>& ray = exact_.question().ray;
    const glm::dvec3& point = *claimed_.point;
    const Scaled size = size_of_point(ray, t_, precision_);
    const auto off = [&](const auto& t) { return units(off_point(ray, t, point, precision_) / size); };
    details.point = off(t_);
    if (is_finite(point)) details.surface = units(exact_.off_surface(in_object(exact_, point), t_));
    if (!hits_.empty()) details.forward = std::visit(off, hits_.front().t);
  }

  void judge_normal(Details& details) const {
    SurfaceParts parts = exact_.parts(t_, Scaled(roundoff_of(precision_)));
    if (parts.empty()) return;
    const auto by_distance = [](const SurfacePart& a, const SurfacePart& b) { return a.apart < b.apart; };
    std::iter_swap(parts.begin(), std::ranges::min_element(parts, by_distance));
    const bool is_sharp = !hits_.empty() && !exact_.normal(hits_.front());
    if (!claimed_.normal)
      details.normal = is_sharp ? 0 : units(error_of_no_normal(exact_, parts, t_));
    else
      details.normal = is_finite(*claimed_.normal)
                           ? units(error_of_normal(exact_, parts, t_, *claimed_.normal))
                           : units(error_of_nan(exact_, parts, t_));
  }

  void judge_coordinates(Details& details) const {
    const auto& weights = claimed_.barycentric;
    ErrorOfCoordinates error{endless(), endless()};
    if (const auto exact = exact_.barycentric()) {
      if (weights) {
        error = error_of_coordinates(*exact, *weights);
        details.coordinates_are_rounded = are_rounded(*exact, *weights, precision_);
      }
    } else if (const auto parameters = exact_.parameters(); claimed_.parameters && parameters) {
      error = error_of_coordinates(*parameters, *claimed_.parameters);
      details.coordinates_are_rounded = are_rounded(*parameters, *claimed_.parameters, precision_);
    } else {
      return;
    }
    details.coordinates = units(error.absolute);
    details.rounded_coordinates = units(error.relative);
    details.condition = value(exact_.condition_of_coordinates(Scaled(roundoff_of(precision_))));
  }

  [[nodiscard]] Details judge() const {
    Details details;
    if (!hits_.empty()) details.contact = hits_.front().contact;
    if (claimed_.hits.count == 0 || !std::isfinite(claimed_.hits.t[0])) return details;
    judge_point(details);
    judge_normal(details);
    judge_coordinates(details);
    return details;
  }

 private:
  [[nodiscard]] double units(const Scaled& error) const { return in_units(error, precision_); }

  const ExactIntersection& exact_;
  ExactContacts hits_;
  Precision precision_;
  const RayAnswer& claimed_;
  Quotient t_;
};

}  // namespace

Details judge_details(const ExactIntersection& exact, Precision precision, const RayAnswer& claimed) {
  return DetailsJudge(exact, precision, claimed).judge();
}

}  // namespace rayproof::oracle
