#include "viz/render/bounds.hpp"

#include <algorithm>

#include "case/case.hpp"
#include "viz/render/figures.hpp"
#include "viz/render/figures/hull.hpp"

namespace rayproof::render {

Bounds Bounds::around(const Bounds& other) const {
  return {glm::min(low, other.low), glm::max(high, other.high)};
}

Bounds Bounds::grown(double margin) const { return {low - margin, high + margin}; }

std::optional<Bounds> bounds_of(const Object& object) {
  const auto& kinds = figure_kinds();
  const auto kind = std::ranges::find(kinds, shape_name(object.shape), &FigureKind::shape);
  if (kind == kinds.end() || kind->enclose == nullptr) return std::nullopt;
  Hull hull(object.transform);
  kind->enclose(hull, object.shape);
  return hull.bounds();
}

}  // namespace rayproof::render
