#include "viz/shapes/topics.hpp"

namespace rayproof::viz {

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

const std::vector<TopicView>& topic_views() {
  static const std::vector<TopicView> views{
      quadratic_view(),         //
      point_in_polygon_view(),  //
      plane_view(),             //
      triangle_view(),          //
      polygon_view(),           //
      sphere_view(),            //
      box_view(),               //
      parallelepiped_view(),    //
      cylinder_view(),          //
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
