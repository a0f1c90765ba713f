#include "properties/diagnosis/models/solids/slabs.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>

#include "properties/claims/answers.hpp"

namespace rayproof::diagnosis {

namespace {

/// The hits where the line is inside from `near(slabs)` to `far(slabs)`.
template <class Near, class Far>
Answers inside_between(const Case& one, Near&& near, Far&& far, bool tests_along = true,
                       unsigned turned = 0) {
  const auto cube = cube_in(one);
  const auto slabs = cube ? slabs_of(*cube, tests_along, turned) : std::nullopt;
  if (!slabs) return {};
  return inside_from(one, near(*slabs), far(*slabs));
}

/// The same, and what is found where a slab that the line runs along inside counts, too: as one that it
/// enters and leaves at infinity, which is no hit.
template <class Near, class Far>
Answers with_endless_slabs(const Case& one, Near&& near, Far&& far) {
  Answers answers = inside_between(one, near, far);
  const auto cube = cube_in(one);
  auto slabs = cube ? slabs_of(*cube) : std::nullopt;
  if (!slabs || slabs->enters.size() == 3) return answers;
  slabs->enters.push_back(-infinity<double>);
  slabs->leaves.push_back(infinity<double>);
  for (const Answer& answer : inside_from(one, near(*slabs), far(*slabs)))
    answers.emplace_back(hits_where(std::get<RayAnswer>(answer), [](double t) { return std::isfinite(t); }));
  return answers;
}

/// One of the six faces.
struct SlabEnd {
  int axis;
  bool is_high;
};

/// The face that the line meets at t, or nearest to it: far from the origin rounding moves a hit beside its
/// face.
SlabEnd face_at(const Cube& cube, double t) {
  SlabEnd nearest{0, false};
  double least = infinity<double>;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool is_high : {false, true}) {
      const double end = is_high ? cube.high[axis] : cube.low[axis];
      const double apart = std::abs((end - cube.ray.origin[axis]) / cube.ray.direction[axis] - t);
      if (!(apart < least)) continue;
      least = apart;
      nearest = {axis, is_high};
    }
  return nearest;
}

/// The hits on faces that are not missing.
template <class IsMissing>
Answers without_faces(const Case& one, IsMissing&& is_missing) {
  const auto cube = cube_in(one);
  if (!cube) return {};
  return {hits_where(hits_of_line(one),
                     [&](double t) { return !is_missing(face_at(*cube, t)) && in_interval(cube->ray, t); })};
}

}  // namespace

std::optional<SlabEnds> slabs_of(const Cube& cube, bool tests_along, unsigned turned) {
  SlabEnds slabs;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = cube.ray.origin[axis], d = cube.ray.direction[axis];
    if (tests_along && d == 0 && (o < cube.low[axis] || o > cube.high[axis])) return std::nullopt;
    if (d == 0) continue;
    const auto [near, far] = std::minmax({(cube.low[axis] - o) / d, (cube.high[axis] - o) / d});
    const bool is_turned = (turned >> static_cast<unsigned>(axis) & 1U) != 0;
    slabs.enters.push_back(is_turned ? far : near);
    slabs.leaves.push_back(is_turned ? near : far);
  }
  return slabs;
}

Answers inside_from(const Case& one, double first, double last) {
  RayAnswer line;
  if (first <= last) line.hits.push_back(first);
  if (first < last) line.hits.push_back(last);
  return {hits_where(line, [&](double t) { return in_interval(ray_question(one)->ray, t); })};
}

Answers through_slabs(const Case& one, const Cube& cube) {
  const auto slabs = slabs_of(cube);
  if (!slabs || slabs->enters.empty()) return {RayAnswer{}};
  return inside_from(one, std::ranges::max(slabs->enters), std::ranges::min(slabs->leaves));
}

Answers leaves_at_last_end(const Case& one, const Answer& /*exact*/) {
  return with_endless_slabs(
      one, [](const SlabEnds& slabs) { return std::ranges::max(slabs.enters); },
      [](const SlabEnds& slabs) { return std::ranges::max(slabs.leaves); });
}

Answers enters_at_first_beginning(const Case& one, const Answer& /*exact*/) {
  return with_endless_slabs(
      one, [](const SlabEnds& slabs) { return std::ranges::min(slabs.enters); },
      [](const SlabEnds& slabs) { return std::ranges::min(slabs.leaves); });
}

Answers slabs_turned(const Case& one, unsigned axes, bool is_always) {
  const auto cube = cube_in(one);
  if (!cube) return {};
  for (unsigned axis = 0; axis < 3; ++axis) {
    const double along = cube->ray.direction[static_cast<int>(axis)];
    const bool is_turned = (axes >> axis & 1U) != 0;
    // From ∞ to -∞. Of other solids the sign of a 0 is their frame's.
    const bool has_sign = !is_always && shape_in<Box<double>>(one) != nullptr;
    if (is_turned && has_sign && along == 0 && std::signbit(along)) return {RayAnswer{}};
    if (along == 0 || (!is_always && along > 0)) axes &= ~(1U << axis);
  }
  if (axes == 0) return {};
  return inside_between(
      one, [](const SlabEnds& slabs) { return std::ranges::max(slabs.enters); },
      [](const SlabEnds& slabs) { return std::ranges::min(slabs.leaves); }, true, axes);
}

Answers slabs_without_signs(const Case& one, const Answer& /*exact*/) {
  const auto cube = cube_in(one);
  auto slabs = cube ? slabs_of(*cube) : std::nullopt;
  if (!slabs) return {};
  for (std::size_t i = 0; i < slabs->enters.size(); ++i) {
    const double near = std::abs(slabs->enters[i]), far = std::abs(slabs->leaves[i]);
    slabs->enters[i] = std::min(near, far);
    slabs->leaves[i] = std::max(near, far);
  }
  return inside_from(one, std::ranges::max(slabs->enters), std::ranges::min(slabs->leaves));
}

Answers slab_along_not_tested(const Case& one, const Answer& /*exact*/) {
  return inside_between(
      one, [](const SlabEnds& slabs) { return std::ranges::max(slabs.enters); },
      [](const SlabEnds& slabs) { return std::ranges::min(slabs.leaves); }, false);
}

Answers slab_divided_by_other(const Case& one, const Answer& /*exact*/) {
  const auto cube = cube_in(one);
  Answers answers;
  if (!cube) return answers;
  for (int axis = 0; axis < 3; ++axis)
    for (const int step : {1, 2}) {
      Cube other = *cube;
      other.ray.direction[axis] = cube->ray.direction[(axis + step) % 3];
      answers.push_back(through_slabs(one, other).front());
    }
  return answers;
}

Answers small_components_as_zero(const Case& one, double least) {
  const auto cube = cube_in(one);
  if (!cube) return {};
  Answers answers;
  for (const double length : {1.0, glm::length(ray_question(one)->ray.direction)}) {
    Cube other = *cube;
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(other.ray.direction[axis]) < least * length) other.ray.direction[axis] = 0;
    if (other.ray.direction == cube->ray.direction) continue;
    answers.push_back(through_slabs(one, other).front());
  }
  return answers;
}

Answers leaves_before_it_enters(const Case& one, const Answer& exact) {
  const auto cube = cube_in(one);
  const auto slabs = cube && !finds_something(exact) ? slabs_of(*cube) : std::nullopt;
  if (!slabs) return {};
  const double enters = std::ranges::max(slabs->enters), leaves = std::ranges::min(slabs->leaves);
  if (enters <= leaves) return {};
  RayAnswer as_found, in_order;
  for (const double t : {enters, leaves}) as_found.hits.push_back(t);
  for (const double t : {leaves, enters}) in_order.hits.push_back(t);
  const auto admits = [&](double t) { return in_interval(cube->ray, t); };
  return {hits_where(as_found, admits), hits_where(in_order, admits)};
}

Answers slabs_upside_down(const Case& one, const Answer& /*exact*/) {
  const auto cube = cube_in(one);
  const auto slabs = cube ? slabs_of(*cube) : std::nullopt;
  if (!slabs) return {};
  double enters = -infinity<double>, leaves = infinity<double>;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = cube->ray.origin[axis], d = cube->ray.direction[axis];
    if (d == 0) continue;
    const auto [near, far] = std::minmax({d / (cube->low[axis] - o), d / (cube->high[axis] - o)});
    enters = std::max(enters, near);
    leaves = std::min(leaves, far);
  }
  return inside_from(one, enters, leaves);
}

Answers missed_along_slab(const Case& one, const Answer& exact) {
  const auto cube = cube_in(one);
  if (!cube || !finds_something(exact)) return {};
  const glm::dvec3& d = cube->ray.direction;
  const bool is_along = d.x == 0 || d.y == 0 || d.z == 0;  // a product would underflow
  return is_along ? Answers{RayAnswer{}} : Answers{};
}

Answers missed_in_face(const Case& one, const Answer& exact, bool at_low, bool at_high) {
  const auto cube = cube_in(one);
  if (!cube || !finds_something(exact)) return {};
  bool is_in_face = false;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = cube->ray.origin[axis];
    const bool is_along = cube->ray.direction[axis] == 0;
    const bool is_in_one = (at_low && o == cube->low[axis]) || (at_high && o == cube->high[axis]);
    is_in_face = is_in_face || (is_along && is_in_one);
  }
  return is_in_face ? Answers{RayAnswer{}} : Answers{};
}

Answers corner_faces_alone(const Case& one, const Answer& /*exact*/) {
  return without_faces(one, [](const SlabEnd& face) { return face.is_high; });
}

Answers face_missing(const Case& one, const Answer& /*exact*/) {
  Answers answers;
  for (const bool is_high : {false, true})
    for (int axis = 0; axis < 3; ++axis)
      for (Answer& answer : without_faces(
               one, [&](const SlabEnd& face) { return face.axis == axis && face.is_high == is_high; }))
        answers.push_back(std::move(answer));
  return answers;
}

}  // namespace rayproof::diagnosis
