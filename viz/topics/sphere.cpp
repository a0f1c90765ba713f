#include <rayproof/sphere/methods.hpp>

#include "viz/topics.hpp"
#include "viz/topics/ray_walk.hpp"
#include "viz/topics/sphere_figure.hpp"
#include "viz/topics/sphere_picture.hpp"

namespace rayproof::viz {

TopicView sphere_view();
TopicView sphere_view() {
  return {sphere::Topic::name, sphere_picture, walk_ray<sphere::Topic>, sphere_figure};
}

}  // namespace rayproof::viz
