#include <rayproof/sphere/methods.hpp>

#include "viz/drawing/topics.hpp"
#include "viz/drawing/topics/ray_walk.hpp"
#include "viz/drawing/topics/sphere_figure.hpp"
#include "viz/drawing/topics/sphere_picture.hpp"

namespace rayproof::viz {

TopicView sphere_view();
TopicView sphere_view() {
  return {sphere::Topic::name, sphere_picture, walk_ray<sphere::Topic>, sphere_figure};
}

}  // namespace rayproof::viz
