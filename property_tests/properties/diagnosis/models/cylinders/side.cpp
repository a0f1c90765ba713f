#include "properties/diagnosis/models/cylinders/side.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/cylinders/caps.hpp"

namespace rayproof::diagnosis {

std::vector<double> listed(const FoundRoots& roots) {
  return roots ? std::vector<double>(roots->begin(), roots->end()) : std::vector<double>{};
}

std::vector<double> roots_of_side(const Case& one) {
  const auto equation = shape_in<Cylinder<double>>(one) == nullptr ? std::nullopt : reduced_equation(one);
  return equation ? listed(roots_by(-equation->h, equation->discriminant(), equation->a))
                  : std::vector<double>{};
}

namespace {

Answers with_root(const Case& one, std::size_t which) {
  const std::vector<double> roots = roots_of_side(one);
  return roots.empty() ? Answers{} : with_side_hits(one, {roots[which]});
}

Answers with_side_ends(const Case& one, const SideEnds& ends) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr) return {};
  return with_side_hits(one, roots_of_side(one), ends);
}

}  // namespace

Answers smaller_side_root_alone(const Case& one, const Answer& /*exact*/) { return with_root(one, 0); }
Answers larger_side_root_alone(const Case& one, const Answer& /*exact*/) { return with_root(one, 1); }

Answers first_side_root_alone(const Case& one, const Answer& /*exact*/) {
  const std::vector<double> roots = roots_of_side(one);
  const auto first =
      std::ranges::find_if(roots, [&](double t) { return in_interval(ray_question(one)->ray, t); });
  return first == roots.end() ? Answers{} : with_side_hits(one, {*first});
}

Answers first_side_hit_decides(const Case& one, const Answer& exact) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  const std::vector<double> roots = roots_of_side(one);
  if (roots.empty() || cylinder->capped || !finds_something(exact)) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const auto is_off = [&](double t) {
    const double z = ray.origin.z + t * ray.direction.z;
    return !(0 <= z && z <= cylinder->height);
  };
  const auto first = std::ranges::find_if(roots, [&](double t) { return in_interval(ray, t); });
  if (first != roots.end() && is_off(*first)) return {RayAnswer{}};
  // Who takes the line's first hit, be it before t_min, misses here, too.
  return is_off(roots.front()) ? Answers{RayAnswer{}, exact} : Answers{};
}

Answers near_height_decides(const Case& one, const Answer& /*exact*/) {
  const std::vector<double> roots = roots_of_side(one);
  if (roots.empty()) return {};
  const double z = point_at(ray_in_object(*ray_question(one)), roots[0]).z;
  const bool is_kept = 0 <= z && z <= shape_in<Cylinder<double>>(one)->height;
  return with_side_hits(one, is_kept ? roots : std::vector<double>{}, {infinity<double>, infinity<double>});
}

Answers upper_cap_elsewhere(const Case& one, const Answer& exact) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr || !cylinder->capped) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  std::vector<double> side = roots_of_side(one);
  if (side.empty() && !reduced_equation(one) && is_in_ellipse(ray.origin.x, ray.origin.y, *cylinder))
    side = {-infinity<double>, infinity<double>};
  if (side.empty()) return {};
  Answers answers;
  for (const double upper :
       {cylinder->height * cylinder->height, 2 * cylinder->height, cylinder->height / 2, 0.0}) {
    const RayAnswer solid = between_ends(one, side[0], side[1], upper);
    for (const bool is_for_all : {true, false})
      answers.push_back(is_for_all || ray.direction.z > 0 ? Answer{solid} : exact);
  }
  return answers;
}

Answers side_without_ends(const Case& one, const Answer& /*exact*/) {
  return with_side_ends(one, {infinity<double>, infinity<double>});
}

Answers side_about_zero(const Case& one, const Answer& /*exact*/) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  return cylinder == nullptr ? Answers{} : with_side_ends(one, {cylinder->height / 2, -cylinder->height / 2});
}

Answers side_by_height_in_world(const Case& one, const Answer& /*exact*/) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr || !ray_question(one)->transform) return {};
  std::vector<double> roots = roots_of_side(one);
  std::erase_if(roots, [&](double t) {
    const double z = point_at(ray_question(one)->ray, t).z;
    return !(0 <= z && z <= cylinder->height);
  });
  return with_side_hits(one, std::move(roots), {infinity<double>, infinity<double>});
}

Answers side_by_mixed_height(const Case& one, const Answer& /*exact*/) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr || !ray_question(one)->transform) return {};
  const Ray<double>& in_world = ray_question(one)->ray;
  const Ray<double> in_object = ray_in_object(*ray_question(one));
  Answers answers;
  for (const bool is_by_direction : {true, false}) {
    const glm::dvec3& origin = is_by_direction ? in_object.origin : in_world.origin;
    const glm::dvec3& direction = is_by_direction ? in_world.direction : in_object.direction;
    std::vector<double> roots = roots_of_side(one);
    std::erase_if(roots, [&](double t) {
      const double z = origin.z + t * direction.z;
      return !(0 <= z && z <= cylinder->height);
    });
    std::ranges::move(with_side_hits(one, std::move(roots), {infinity<double>, infinity<double>}),
                      std::back_inserter(answers));
  }
  return answers;
}

Answers side_goes_on(const Case& one, bool is_upwards) {
  return with_side_ends(one, is_upwards ? SideEnds{0, infinity<double>} : SideEnds{infinity<double>, 0});
}

Answers caps_where_side_missed(const Case& one, const Answer& exact) {
  if (!finds_something(exact)) return {};
  const std::vector<Case> open =
      with_shape<Cylinder<double>>(one, [](RayQuestion& /*asked*/, Cylinder<double>& cylinder) {
        return std::exchange(cylinder.capped, false);
      });
  if (open.empty()) return {};
  const RayAnswer on_line = hits_of_line(open.front());
  if (on_line.hits.count == 0) return {};
  return {hits_where(on_line, [&](double t) { return in_interval(ray_question(one)->ray, t); })};
}

Answers side_where_caps_missed(const Case& one, const Answer& /*exact*/) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr || !cylinder->capped) return {};
  std::vector<double> caps = hits_of_caps(one, *cylinder, is_in_ellipse);
  return caps.empty() ? Answers{} : Answers{in_order(one, std::move(caps))};
}

Answers side_mirrored(const Case& one, const Answer& /*exact*/) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr) return {};
  return with_side_hits(one, roots_of_side(one), {.below = cylinder->height, .above = 0});
}

}  // namespace rayproof::diagnosis
