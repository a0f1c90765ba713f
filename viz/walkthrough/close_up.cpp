#include "viz/walkthrough/setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/explain/case_report.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

constexpr double profile_reach = 5.5;  ///< in gaps: what is drawn to each side

bool can_be_drawn(double gap) { return std::isnormal(gap) && std::isfinite(1 / gap); }

StageItem measure(const glm::dvec3& from, const glm::dvec3& to, double gap) {
  return segment(Role::nearest, from, to, rough(gap, 2) + " between");
}

/// The axes of the profile: `up` from the outline to the ray, `right` as the ray runs.
struct Profile {
  Place right, up;
  bool runs_along;  ///< the outline is level, not seen end-on

  [[nodiscard]] glm::dvec3 direction(const Place& v) const {
    return rounded(unit(Place{dot(v, right), dot(v, up), 0}));
  }
};

Profile profile_of(const RayScene& scene, const NearestPass& nearest) {
  const Place up = unit(scene.at(nearest.t) - nearest.on_outline);
  const Place side = unit(nearest.border->line[1] - nearest.border->line[0]);
  const Place right = cross(up, side);
  const bool runs_along = length(right) == 0 || abs(dot(unit(right), scene.along_ray)) < Shadow(1e-3);
  if (runs_along) return {scene.along_ray, up, true};
  return {dot(right, scene.along_ray) < 0 ? unit(Shadow(-1) * right) : unit(right), up, false};
}

/// The surface below the ray, whose outline is at 0.
Items surface_of(const NearestPass& nearest, const Profile& profile) {
  const glm::dvec3 level{profile_reach, 0, 0};
  if (nearest.border->into.empty() || profile.runs_along) {
    const glm::dvec3 down{0, -profile_reach, 0};
    return {open_polygon(Role::surface, {-level, level, level + down, down - level}),
            segment(Role::surface, -level, level)};
  }
  Items items;
  std::vector<glm::dvec3> corners{{0, 0, 0}};
  for (const Place& into : nearest.border->into) {
    corners.push_back(profile_reach * profile.direction(into));
    items.push_back(segment(Role::surface, {0, 0, 0}, corners.back()));
  }
  if (corners.size() > 2) items.push_back(open_polygon(Role::surface, corners));
  return items;
}

void add_hits(Items& items, const Answer* answer, Role role, const char* word,
              const std::function<double(double t)>& place) {
  for (const double t : values_of(answer)) {
    const double x = std::isfinite(t) ? place(t) : profile_reach;
    if (std::abs(x) < 3.4) items.push_back(point(role, {x, 1, 0}, word));
  }
}

}  // namespace

std::optional<CloseUp> close_up_of(const RayScene& scene, const CaseReport& report,
                                   const StageCamera& camera) {
  const std::optional<NearestPass> nearest = nearest_of(scene);
  if (!nearest) return std::nullopt;
  // A gap of 2^-200 of the scene is the rounding of these numbers.
  const Shadow size =
      length(nearest->on_outline) + length(nearest->border->line[1] - nearest->border->line[0]);
  const bool is_met = nearest->gap <= ldexp(size, -200);
  const Ray<double>& ray = scene.sight.question.ray;
  const bool is_point = ray.t_min == ray.t_max;
  CloseUp shown{is_met ? 0 : static_cast<double>(nearest->gap)};
  if (is_met) {
    shown.words = is_point ? "The ray is one point of the outline." : "The ray passes through the outline.";
  } else {
    shown.words = fmt::format("The ray {} {} from the outline.", is_point ? "is one point," : "passes",
                              rough(nearest->gap, 3));
  }
  if (!can_be_drawn(shown.gap)) return shown;
  const Profile profile = profile_of(scene, *nearest);
  shown.items = surface_of(*nearest, profile);
  shown.items.push_back(arrow(Role::ray, {-profile_reach, 1, 0}, {3.4, 1, 0}));
  shown.items.push_back(measure({0, 0, 0}, {0, 1, 0}, shown.gap));
  const Shadow speed = dot(scene.sight.ray.direction, profile.right) / nearest->gap;
  const auto place = [&](double t) { return static_cast<double>((Shadow(t) - nearest->t) * speed); };
  add_hits(shown.items, &report.exact, Role::exact, "exact", place);
  add_hits(shown.items, report.claim(), Role::claimed, "as computed", place);
  for (StageItem& item : shown.items) {
    for (glm::dvec3& p : item.points) p = p.x * camera.right + (p.y - 0.5) * camera.up;
  }
  return shown;
}

CloseUp close_up_of(const std::vector<glm::dvec3>& ring, const glm::dvec3& p) {
  const auto nearest_on = [&](std::size_t i) {
    const glm::dvec3& from = ring[i];
    const glm::dvec3 side = ring[(i + 1) % ring.size()] - from;
    const double square = glm::dot(side, side);
    return from + (square > 0 ? std::clamp(glm::dot(p - from, side) / square, 0.0, 1.0) : 0.0) * side;
  };
  glm::dvec3 nearest = ring.front();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (glm::length(nearest_on(i) - p) < glm::length(nearest - p)) nearest = nearest_on(i);
  }
  CloseUp shown{glm::length(nearest - p)};
  shown.words = shown.gap == 0 ? "The point lies on the boundary."
                               : fmt::format("The point lies {} from the boundary.", rough(shown.gap, 3));
  if (!can_be_drawn(shown.gap)) return shown;
  const glm::dvec3 middle = 0.5 * (nearest + p);
  const auto placed = [&](const glm::dvec3& q) { return (q - middle) / shown.gap; };
  std::vector<glm::dvec3> filled;
  for (const glm::dvec3& vertex : ring) filled.push_back(placed(vertex));
  constexpr double most = 1e100;  // in gaps: its squares must not overflow
  const auto is_drawable = [](const glm::dvec3& v) { return std::abs(v.x) < most && std::abs(v.y) < most; };
  if (std::ranges::all_of(filled, is_drawable)) shown.items.push_back(open_polygon(Role::surface, filled));
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (glm::length(nearest_on(i) - middle) < profile_reach * shown.gap)
      shown.items.push_back(segment(Role::surface, placed(ring[i]), placed(ring[(i + 1) % ring.size()])));
  }
  const glm::dvec3 at = placed(p);
  shown.items.push_back(arrow(Role::ray, at, at + glm::dvec3(3.4, 0, 0), "+x"));
  shown.items.push_back(measure(placed(nearest), at, shown.gap));
  shown.items.push_back(point(Role::ray, at, "p"));
  return shown;
}

}  // namespace rayproof::viz
