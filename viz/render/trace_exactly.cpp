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
  HitImage image(scene.width, scene.height);
  for_each_pixel(scene.width, scene.height, work, [&](int x, int y) {
    image.set(x, y, exact_nearest(scene, neighbourhood, pixel_ray(scene, x, y)));
  });
  return image;
}

}  // namespace rayproof::render
