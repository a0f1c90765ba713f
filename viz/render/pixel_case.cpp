#include "viz/render/pixel_case.hpp"

#include <fmt/format.h>

namespace rayproof::render {

std::string object_name(const RenderScene& scene, ObjectIndex object) {
  const std::size_t entry = scene.objects[object].entry;
  std::size_t first = object;
  while (first > 0 && scene.objects[first - 1].entry == entry) --first;
  const bool is_of_mesh =
      first != object || (object + 1 < scene.objects.size() && scene.objects[object + 1].entry == entry);
  const std::string shape = fmt::format("shapes[{}]", entry);
  return is_of_mesh ? fmt::format("triangle {} of {}", object - first, shape) : shape;
}

PixelHits hits_at(const RenderScene& scene, int x, int y, const Methods& methods) {
  const bool has_many = scene.objects.size() >= many_objects;
  const Neighbourhood near = has_many ? bounds_tree(scene, method_margin) : nullptr;
  return {exact_nearest_at(scene, bounds_tree(scene), x, y), nearest_at(scene, methods, near, x, y)};
}

Case pixel_case(const RenderScene& scene, int x, int y, ObjectIndex object, const PixelHits& hits) {
  const Object& asked = scene.objects[object];
  const auto in_words = [&](ObjectIndex hit) {
    return hit == no_object ? "nothing" : object_name(scene, hit);
  };
  Case one;
  one.precision = scene.precision;
  one.note = fmt::format(
      "pixel ({}, {}) of {} at {}x{}, about {}: exactly the ray meets {} first, by the methods {}", x, y,
      scene.file, scene.width, scene.height, object_name(scene, object), in_words(hits.exact),
      in_words(hits.claimed));
  one.question = RayQuestion{pixel_ray(scene, x, y), asked.shape, asked.transform};
  return one;
}

}  // namespace rayproof::render
