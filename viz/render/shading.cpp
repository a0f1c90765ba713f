#include "viz/render/shading.hpp"

#include <cmath>

#include "subjects/reading.hpp"
#include "viz/render/colours.hpp"
#include "viz/render/tiles.hpp"

namespace rayproof::render {
namespace {

/// The unit normal in the world at t, either way round; NaN where the figure has none.
glm::dvec3 normal_at_hit(const Object& object, const Ray<double>& ray, double t) {
  const auto space = object.transform ? std::optional(object_space<double>(*object.transform)) : std::nullopt;
  return std::visit([&](const auto& shape) { return normal_in_world(space, library_shape(shape), ray, t); },
                    object.shape);
}

/// How much of a colour the eye gets: 1 where it looks straight down on the surface.
double brightness(const Object& object, const Ray<double>& ray, double t) {
  constexpr double least = 0.25;
  const glm::dvec3 normal = normal_at_hit(object, ray, t);
  const double cosine = std::abs(dot(normal, ray.direction)) / std::sqrt(dot(ray.direction, ray.direction));
  return std::isfinite(cosine) ? least + (1 - least) * std::min(cosine, 1.0) : least;
}

}  // namespace

viz::Raster shaded(const RenderScene& scene, const HitImage& hits, Shade shade, const Work& work) {
  viz::Raster raster(hits.width, hits.height, background);
  for_each_pixel(hits.width, hits.height, work, [&](int x, int y) {
    const std::size_t i = hits.index(x, y);
    if (hits.object[i] == no_object) return;
    const Object& object = scene.objects[hits.object[i]];
    const Rgb colour = object_colours[object.entry % object_colours.size()];
    raster.at(x, y) =
        shade == Shade::flat ? colour : dimmed(colour, brightness(object, pixel_ray(scene, x, y), hits.t[i]));
  });
  return raster;
}

}  // namespace rayproof::render
