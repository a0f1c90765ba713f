#include "properties/diagnosis/models/cylinders/ends.hpp"

#include <algorithm>
#include <cmath>

#include "properties/boundary.hpp"
#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/curved/root_formula.hpp"
#include "properties/diagnosis/models/cylinders/caps.hpp"
#include "properties/diagnosis/models/cylinders/side.hpp"
#include "properties/edges.hpp"

namespace rayproof::diagnosis {
namespace {

/// How many times its size a cylinder is long that has no end.
constexpr double without_end = 0x1p30;

double size_of(const Cylinder<double>& cylinder) {
  return std::max({cylinder.height, cylinder.rx, cylinder.ry});
}

/// The exact hits without those of which `is_dropped(z, height)` is true, z in object space; none where
/// nothing is dropped, or rounding decides.
template <class Dropped>
Answers without_heights(const Case& one, const Answer& exact, Dropped&& is_dropped) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const auto& all = std::get<RayAnswer>(exact);
  const RayAnswer left = hits_where(
      all, [&](double t) { return !is_dropped(ray.origin.z + t * ray.direction.z, cylinder->height); });
  const bool is_decided = left.hits.count < all.hits.count && is_exact_for_some_method(one);
  return is_decided ? Answers{left} : Answers{};
}

/// Whether z, the sum of these two, is 0 but for its rounding.
bool is_zero(double z, double size) { return std::abs(z) <= 0x1p-40 * size; }

/// Without the hits at which the ray passes the plane z = height of the object's space.
Answers without_hits_at(const Case& one, const Answer& exact, bool is_upper) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr || !cylinder->capped) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const double t_cap = ((is_upper ? cylinder->height : 0) - ray.origin.z) / ray.direction.z;
  const auto& all = std::get<RayAnswer>(exact);
  const RayAnswer left = hits_where(
      all, [&](double t) { return !(std::abs(t - t_cap) <= 0x1p-16 * (std::abs(t) + std::abs(t_cap))); });
  return left.hits.count == all.hits.count ? Answers{} : Answers{left};
}

/// The cylinder made longer at one end, without what lies at the new end.
Answers lengthened(const Case& one, bool is_upwards) {
  double length = 0;
  const auto longer = with_shape<Cylinder<double>>(one, [&](RayQuestion& asked, Cylinder<double>& cylinder) {
    length = without_end * size_of(cylinder);
    cylinder.height += length;
    if (!is_upwards) lift(asked, -length);
    return true;
  });
  if (longer.empty()) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const auto all = std::get<RayAnswer>(oracle::answer(longer.front()));
  Answers answers = side_goes_on(one, is_upwards);  // where the cap at that end is looked for, too
  answers.push_back(
      hits_where(all, [&](double t) { return std::abs(ray.origin.z + t * ray.direction.z) < length / 2; }));
  return answers;
}

/// The side, and of the planes of both ends what `is_in_cap(x, y, cylinder)` takes for a cap: the first two
/// hits, or the first and the last.
template <class InCap>
Answers with_ends(const Case& one, InCap&& is_in_cap) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr || !cylinder->capped) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const std::vector<Case> open =
      with_shape<Cylinder<double>>(one, [](RayQuestion& /*asked*/, Cylinder<double>& changed) {
        changed.capped = false;
        return true;
      });
  if (open.empty() || ray.direction.z == 0) return {};
  const RayAnswer of_side = hits_of_line(open.front());
  std::vector<double> all(of_side.hits.view().begin(), of_side.hits.view().end());
  for (const double z : {0.0, cylinder->height}) {
    const double t = (z - ray.origin.z) / ray.direction.z;
    const glm::dvec3 point = point_at(ray, t);
    if (is_in_cap(point.x, point.y, *cylinder)) all.push_back(t);
  }
  std::ranges::sort(all);
  const auto admits = [&](double t) { return in_interval(ray_question(one)->ray, t); };
  RayAnswer first_two, ends;
  for (const double t : all)
    if (admits(t) && first_two.hits.count < first_two.hits.t.size()) first_two.hits.push_back(t);
  Answers answers{first_two};
  if (all.size() > 2) {
    for (const double t : {all.front(), all.back()})
      if (admits(t)) ends.hits.push_back(t);
    answers.emplace_back(ends);
  }
  // Who looks for the side first may leave off where the line passes it by.
  const auto equation = reduced_equation(one);
  if (equation && equation->discriminant() < 0) answers.emplace_back(RayAnswer{});
  return answers;
}

}  // namespace

void lift(RayQuestion& asked, double by) {
  glm::dmat4 map = asked.transform.value_or(glm::dmat4(1));
  map[3] += by * map[2];
  asked.transform = map;
}

std::vector<Case> endless_cylinder(const Case& one) {
  return with_shape<Cylinder<double>>(one, [](RayQuestion& asked, Cylinder<double>& cylinder) {
    const double half = without_end * size_of(cylinder);
    lift(asked, -half);
    cylinder.height = 2 * half;
    cylinder.capped = false;
    return true;
  });
}

Answers missed_along_axis(const Case& one, const Answer& exact) {
  if (shape_in<Cylinder<double>>(one) == nullptr || !finds_something(exact)) return {};
  const glm::dvec3 d = glm::abs(ray_in_object(*ray_question(one)).direction);
  const double across = std::max(d.x, d.y);
  const bool is_rim = is_at_rim(one, std::get<RayAnswer>(exact).hits.t[0], share_of_rounding(one.precision));
  if (across == 0 && !is_rim) return {RayAnswer{}};
  // Of a transform rounding decides.
  return across < 0x1p-20 * d.z ? Answers{RayAnswer{}, exact} : Answers{};
}

Answers missed_across_axis(const Case& one, const Answer& exact) {
  if (shape_in<Cylinder<double>>(one) == nullptr || !finds_something(exact)) return {};
  const glm::dvec3 d = glm::abs(ray_in_object(*ray_question(one)).direction);
  if (d.z == 0) return {RayAnswer{}};
  // Of a transform rounding decides.
  return d.z < 0x1p-20 * std::max(d.x, d.y) && ray_question(one)->transform ? Answers{RayAnswer{}, exact}
                                                                            : Answers{};
}

Answers missed_along_axis_inside(const Case& one, const Answer& exact) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr) return {};
  const double z = ray_in_object(*ray_question(one)).origin.z;
  return 0 < z && z < cylinder->height ? missed_along_axis(one, exact) : Answers{};
}

Answers no_height_is_missed(const Case& one, const Answer& exact) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  const bool is_hit = cylinder != nullptr && cylinder->height == 0 && finds_something(exact);
  return is_hit ? Answers{RayAnswer{}} : Answers{};
}

Answers missed_along_side(const Case& one, const Answer& exact) {
  if (shape_in<Cylinder<double>>(one) == nullptr || !finds_something(exact)) return {};
  const bool is_there = boundary_places(one).test(static_cast<std::size_t>(BoundaryPlace::along_side));
  return is_there ? Answers{RayAnswer{}} : Answers{};
}

namespace {

/// What is hit of a capped cylinder by a ray that is taken for one along the axis.
Answers caps_by_origin_alone(const Case& one) {
  const auto& cylinder = *shape_in<Cylinder<double>>(one);
  const Ray<double> ray = ray_in_object(*ray_question(one));
  if (!cylinder.capped) return {};
  if (!is_in_ellipse(ray.origin.x, ray.origin.y, cylinder)) return {RayAnswer{}};
  if (ray.direction.z == 0) return {};
  const double low = -ray.origin.z / ray.direction.z;
  std::vector<double> caps{low, low + cylinder.height / ray.direction.z};
  std::ranges::sort(caps);
  return {in_order(one, caps)};
}

}  // namespace

Answers side_missed_along(const Case& one, double least) {
  const auto equation = shape_in<Cylinder<double>>(one) == nullptr ? std::nullopt : reduced_equation(one);
  if (!equation) return {};
  const glm::dvec3 d = ray_in_object(*ray_question(one)).direction;
  const bool is_scaled = equation->a < least, is_plain = d.x * d.x + d.y * d.y < least;
  if (!is_scaled && !is_plain) return {};
  Answers answers = with_side_hits(one, {});
  // Caps may be tested at the origin then, where x and y are taken not to change.
  for (Answer& answer : caps_by_origin_alone(one)) answers.push_back(std::move(answer));
  if (is_scaled != is_plain) answers.push_back(oracle::answer(one));
  return answers;
}

Answers caps_without_rim(const Case& one, const Answer& /*exact*/) {
  return with_ends(one, [](double, double, const Cylinder<double>&) { return true; });
}
Answers caps_as_rectangles(const Case& one, const Answer& /*exact*/) {
  return with_ends(one, [](double x, double y, const Cylinder<double>& cylinder) {
    return std::abs(x) <= cylinder.rx && std::abs(y) <= cylinder.ry;
  });
}

Answers no_lower_cap(const Case& one, const Answer& exact) { return without_hits_at(one, exact, false); }
Answers no_upper_cap(const Case& one, const Answer& exact) { return without_hits_at(one, exact, true); }

Answers upper_end_not_tested(const Case& one, const Answer& /*exact*/) { return lengthened(one, true); }
Answers lower_end_not_tested(const Case& one, const Answer& /*exact*/) { return lengthened(one, false); }

Answers end_tested_one_way(const Case& one, const Answer& exact) {
  if (shape_in<Cylinder<double>>(one) == nullptr) return {};
  const bool rises = ray_in_object(*ray_question(one)).direction.z > 0;
  Answers answers;
  for (const bool is_upper : {true, false})
    for (const bool is_of_rising : {true, false}) {
      const Answers longer = rises == is_of_rising ? lengthened(one, is_upper) : Answers{};
      answers.push_back(longer.empty() ? exact : longer.back());
    }
  return answers;
}

Answers radius_as_height(const Case& one, const Answer& /*exact*/) {
  const std::vector<Case> endless = endless_cylinder(one);
  if (endless.empty()) return {};
  double longer = 0;
  Answers answers =
      exact_of(with_shape<Cylinder<double>>(one, [&](RayQuestion& /*asked*/, Cylinder<double>& cylinder) {
        longer = cylinder.rx - cylinder.height;
        cylinder.height = cylinder.rx;
        return true;
      }));
  const RayAnswer side = hits_of_line(endless.front());
  const auto hits = side.hits.view();
  answers.push_back(with_side_hits(one, {hits.begin(), hits.end()}, {.above = longer}).front());
  return answers;
}

Answers without_low_rim(const Case& one, const Answer& exact) {
  return without_heights(one, exact, [](double z, double height) { return is_zero(z, height); });
}
Answers without_high_rim(const Case& one, const Answer& exact) {
  return without_heights(one, exact, [](double z, double height) { return is_zero(z - height, height); });
}
Answers without_rims(const Case& one, const Answer& exact) {
  return without_heights(
      one, exact, [](double z, double height) { return is_zero(z, height) || is_zero(z - height, height); });
}

}  // namespace rayproof::diagnosis
