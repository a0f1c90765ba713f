#pragma once
/// \file
/// The registration of the pictures' layer: how each shape looks; and the walkthroughs of all topics.

#include <optional>
#include <string>

#include "case/case.hpp"
#include "viz/shapes/figure.hpp"
#include "viz/trace/walkthrough.hpp"

namespace rayproof::viz {

// What a shape looks like in space, each in NAME.cpp.
Figure figure_of(const Sight& sight, const Plane<double>& given);
Figure figure_of(const Sight& sight, const Triangle<double>& triangle);
Figure figure_of(const Sight& sight, const Polygon<double>& polygon);
Figure figure_of(const Sight& sight, const Sphere<double>& given);
Figure figure_of(const Sight& sight, const rayproof::Box<double>& given);
Figure figure_of(const Sight& sight, const Parallelepiped<double>& given);
Figure figure_of(const Sight& sight, const Cylinder<double>& given);
[[nodiscard]] Figure figure_of(const Sight& sight);

/// The method's run on the case; nothing where the case's topic has no such method, or one that can't be
/// recorded.
[[nodiscard]] std::optional<Walkthrough> recorded_walk(const Case& one, const std::string& method);

}  // namespace rayproof::viz
