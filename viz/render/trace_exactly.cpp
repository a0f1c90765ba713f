/// \file
/// Hits by the oracle.

#include "oracle/oracle.hpp"
#include "viz/render/hits.hpp"
#include "viz/render/tiles.hpp"

namespace rayproof::render {
namespace {

/// Asks the objects near the ray one after another, keeping the nearest.
Nearest<double> exact_nearest(const RenderScene& scene, const Neighbourhood& neighbourhood,
                              const Ray<double>& ray) {
  Nearest<double> nearest;
  auto ask = [&](ObjectIndex object) {
    const ExactHit hit = exact_hit(scene, object, ray);
    if (hit.is_hit) nearest.take(hit.t, object);
    return beyond_rounding(nearest.t);
  };
  neighbourhood.visit(ray, ask);
  return nearest;
}

template <class T>
HitImage trace_exactly_in(const RenderScene& scene, const Neighbourhood& neighbourhood, const Work& work) {
  HitImage image(scene.width, scene.height);
  const PixelRays<T> pixel_rays(scene);
  for_each_tile(scene.width, scene.height, work, [&](const Tile& tile) {
    for_each_pixel(tile, [&](int x, int y) {
      image.set(x, y, exact_nearest(scene, neighbourhood, convert<double>(pixel_rays(x, y))));
    });
  });
  return image;
}

}  // namespace

ExactHit exact_hit(const RenderScene& scene, ObjectIndex object, const Ray<double>& ray) {
  const Object& asked = scene.objects[object];
  const Case one{{}, scene.precision, {}, RayQuestion{ray, asked.shape, asked.transform}};
  const auto answer = std::get<RayAnswer>(oracle::answer(one));
  if (answer.hits.count == 0) return {};
  return {true, answer.hits.t[0]};
}

ObjectIndex exact_nearest_at(const RenderScene& scene, const Neighbourhood& neighbourhood, int x, int y) {
  return exact_nearest(scene, neighbourhood, pixel_ray(scene, x, y)).object;
}

HitImage trace_exactly(const RenderScene& scene, const Neighbourhood& neighbourhood, const Work& work) {
  return scene.precision == Precision::float32 ? trace_exactly_in<float>(scene, neighbourhood, work)
                                               : trace_exactly_in<double>(scene, neighbourhood, work);
}

}  // namespace rayproof::render
