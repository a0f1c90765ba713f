#pragma once
/// \file
/// The registration of the pictures' layer: how each topic looks, and its walkthroughs.

#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "viz/shapes/figure.hpp"
#include "viz/trace/walkthrough.hpp"

namespace rayproof::viz {

/// A topic's look and walkthroughs.
struct TopicView {
  std::string name;  ///< "sphere"
  /// The method's run on the case; nothing where the topic has no such method, or one that can't be recorded.
  std::optional<Walkthrough> (*walk)(const Case& one, const std::string& method) = nullptr;
  /// What the shape looks like in space; null for a question about no shape.
  Figure (*figure)(const Sight& sight) = nullptr;
};

// Each in NAME.cpp.
TopicView quadratic_view();
TopicView point_in_polygon_view();
TopicView plane_view();
TopicView triangle_view();
TopicView polygon_view();
TopicView sphere_view();
TopicView box_view();
TopicView parallelepiped_view();
TopicView cylinder_view();

/// Every topic with a view, in the order of the registries.
inline constexpr TopicView (*topic_views[])() = {
    quadratic_view,         //
    point_in_polygon_view,  //
    plane_view,             //
    triangle_view,          //
    polygon_view,           //
    sphere_view,            //
    box_view,               //
    parallelepiped_view,    //
    cylinder_view,          //
};

/// The view of a case's topic, or null.
[[nodiscard]] const TopicView* view_of(const Case& one);

}  // namespace rayproof::viz
