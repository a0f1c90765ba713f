#include <rayproof/triangle/methods.hpp>

#include "viz/shapes/topics.hpp"

namespace rayproof::viz {

Figure figure_of(const Sight& sight, const Triangle<double>& triangle) {
  const Place a = sight.world.point(triangle.a);
  const Place b = sight.world.point(triangle.b);
  const Place c = sight.world.point(triangle.c);
  return flat_figure({a, b, c}, cross(b - a, c - a), {"a", "b", "c"});
}

}  // namespace rayproof::viz
