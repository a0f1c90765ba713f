#include "viz/shapes/topics.hpp"

#include <algorithm>

namespace rayproof::viz {

const TopicView* view_of(const Case& one) {
  static const std::vector<TopicView> views = [] {
    std::vector<TopicView> all;
    for (const auto make : topic_views) all.push_back(make());
    return all;
  }();
  const auto found = std::ranges::find(views, topic_of(one), &TopicView::name);
  return found == views.end() ? nullptr : &*found;
}

}  // namespace rayproof::viz
