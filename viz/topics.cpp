#include "viz/topics.hpp"

namespace rayproof::viz {

// Each in topics/NAME.cpp.
TopicView sphere_view();
TopicView quadratic_view();

const std::vector<TopicView>& topic_views() {
  static const std::vector<TopicView> views{
      quadratic_view(),
      sphere_view(),
  };
  return views;
}

const TopicView* view_of(const Case& one) {
  const std::string topic = topic_of(one);
  for (const TopicView& view : topic_views()) {
    if (view.name == topic) return &view;
  }
  return nullptr;
}

}  // namespace rayproof::viz
