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

/// Every topic with a view, in the order of the registries.
[[nodiscard]] const std::vector<TopicView>& topic_views();

/// The view of a case's topic, or null.
[[nodiscard]] const TopicView* view_of(const Case& one);

}  // namespace rayproof::viz
