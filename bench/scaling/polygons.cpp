#include "bench/contenders/contender.hpp"
#include "bench/scaling/scaling.hpp"
#include "generators/draw.hpp"
#include "generators/outline.hpp"

namespace rayproof::report {

namespace {

glm::dvec3 draw_point(Random& random, double size) {
  const double x = random.uniform(-size, size), y = random.uniform(-size, size),
               z = random.uniform(-size, size);
  return {x, y, z};
}

/// A star of `count` vertices in the plane and a point near it; in space, a ray that meets its plane near it.
Case star_case(const std::string& topic, Random& random, int count) {
  const Outline outline = star(random, count);
  Case one;
  one.precision = Precision::float32;
  const double x = random.uniform(-6, 6), y = random.uniform(-6, 6);
  if (topic == "point_in_polygon") {
    one.question = PointAndPolygon<double>{{x, y}, outline};
    return one;
  }
  const glm::dvec3 center = draw_point(random, 10), u = draw::unit_vector(random);
  const glm::dvec3 v = glm::normalize(glm::cross(u, draw::unit_vector(random)));
  Polygon<double> polygon;
  for (const auto& corner : outline) polygon.vertices.push_back(center + corner.x * u + corner.y * v);
  const glm::dvec3 origin = center + 3.0 * draw_point(random, 10);
  one.question = RayQuestion{{origin, center + x * u + y * v - origin}, polygon};
  return one;
}

}  // namespace

std::vector<ScalingStep> polygon_scaling(const BenchOptions& options) {
  const double seconds = options.seconds;
  std::vector<ScalingStep> steps;
  for (const char* const topic : {"polygon", "point_in_polygon"})
    for (const std::size_t size : {3, 10, 30, 100, 300, 1000}) {
      const auto measure = [seconds](const BenchRow& pattern) {
        // As many polygons as lie in the nearer caches.
        const std::size_t count = std::clamp<std::size_t>(32'768 / pattern.size, 128, 2048);
        Random random(pattern.size);
        std::vector<Case> cases;
        while (cases.size() < count)
          cases.push_back(star_case(pattern.shape, random, static_cast<int>(pattern.size)));
        std::vector<Contender> timed = contenders(pattern.shape, cases, pattern.precision);
        std::erase_if(timed, [](const Contender& one) { return one.method.starts_with("printed"); });
        return timed_rows(timed, pattern, count, seconds);
      };
      steps.push_back({{.shape = topic, .family = "polygon_size", .size = size}, measure});
    }
  return steps;
}

}  // namespace rayproof::report
