#include "properties/diagnosis/models/curved/side.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/curved/caps.hpp"
#include "properties/diagnosis/models/curved/root_formula.hpp"

namespace rayproof::diagnosis {
namespace {

/// The roots of the side without end, ascending; none where the line passes it by, or of another shape.
std::vector<double> roots_of_side(const Case& one) {
  const auto equation = shape_in<Cylinder<double>>(one) == nullptr ? std::nullopt : reduced_equation(one);
  const FoundRoots roots =
      equation ? roots_by(-equation->h, equation->discriminant(), equation->a) : std::nullopt;
  return roots ? std::vector<double>(roots->begin(), roots->end()) : std::vector<double>{};
}

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

Answers side_without_ends(const Case& one, const Answer& /*exact*/) {
  return with_side_ends(one, {infinity<double>, infinity<double>});
}

Answers side_goes_on(const Case& one, bool is_upwards) {
  return with_side_ends(one, is_upwards ? SideEnds{0, infinity<double>} : SideEnds{infinity<double>, 0});
}

Answers direction_not_divided_by_radii(const Case& one, const Answer& /*exact*/) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const glm::dvec2 o = glm::dvec2(ray.origin) / glm::dvec2(cylinder->rx, cylinder->ry), d(ray.direction);
  const ReducedEquation wrong{glm::dot(d, d), glm::dot(o, d), glm::dot(o, o) - 1};
  const FoundRoots roots = roots_by(-wrong.h, wrong.discriminant(), wrong.a);
  return with_side_hits(one,
                        roots ? std::vector<double>(roots->begin(), roots->end()) : std::vector<double>{});
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

}  // namespace rayproof::diagnosis
