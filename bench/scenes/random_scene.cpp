#include "bench/scenes/random_scene.hpp"

#include <cmath>

#include "generators/random.hpp"

namespace rayproof::report {

namespace {

constexpr float half_side = 100;

glm::vec3 draw_vector(Random& random, float length) {
  const auto draw = [&] { return static_cast<float>(random.uniform(-1, 1)) * length; };
  const float x = draw(), y = draw(), z = draw();
  return {x, y, z};
}

}  // namespace

RandomScene random_scene(const std::string& kind, std::size_t count) {
  const std::size_t triangles = kind == "spheres" ? 0 : kind == "triangles" ? count : count / 2;
  const float size = half_side / std::sqrt(static_cast<float>(count));
  Random random(count);
  RandomScene scene;
  while (scene.spheres.size() < count - triangles)
    scene.spheres.push_back({draw_vector(random, half_side), size});
  while (scene.triangles.size() < triangles) {
    const glm::vec3 a = draw_vector(random, half_side);
    const glm::vec3 b = a + draw_vector(random, 2 * size), c = a + draw_vector(random, 2 * size);
    scene.triangles.push_back({a, b, c});
  }
  return scene;
}

std::vector<Ray<float>> rays_through_scene() {
  Random random(18);
  std::vector<Ray<float>> rays;
  while (rays.size() < 4096) {
    const glm::vec3 target = draw_vector(random, half_side);
    const glm::vec3 origin = 3.0F * draw_vector(random, half_side);
    rays.push_back({origin, target - origin});
  }
  return rays;
}

}  // namespace rayproof::report
