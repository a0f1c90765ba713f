/// \file
/// Hits by the oracle.

#include <cmath>

#include "oracle/oracle.hpp"
#include "viz/scene/hits.hpp"
#include "viz/scene/tiles.hpp"

namespace rayproof::render {
namespace {

/// Asks objects one after another, keeping the nearest.
class ExactNearest {
 public:
  ExactNearest(const Scene& scene, const Ray<double>& ray) : scene_(scene), ray_(ray) {}

  /// Gives back a t beyond which no exact hit can round to less than the nearest.
  double operator()(ObjectIndex object) {
    const ExactHit hit = exact_hit(scene_, object, ray_);
    const bool is_nearer =
        hit.is_hit && (object_ == no_object || hit.t < t_ || (hit.t == t_ && object < object_));
    if (is_nearer) {
      t_ = hit.t;
      object_ = object;
    }
    // A float's neighbour is at most 2^-23 away; below the normal floats they are 2^-149 apart.
    return t_ + std::abs(t_) * 0x1p-22 + 0x1p-148;
  }

  [[nodiscard]] double t() const { return t_; }
  [[nodiscard]] ObjectIndex object() const { return object_; }

 private:
  const Scene& scene_;
  const Ray<double>& ray_;
  double t_ = HUGE_VAL;
  ObjectIndex object_ = no_object;
};

template <class T>
HitImage trace_exactly_in(const Scene& scene, const Neighbourhood& neighbourhood, const Work& work) {
  HitImage image(scene.width, scene.height);
  const PixelRays<T> pixel_rays(scene);
  for_each_tile(scene.width, scene.height, work, [&](const Tile& tile) {
    for (int y = tile.top; y < tile.bottom; ++y) {
      for (int x = tile.left; x < tile.right; ++x) {
        const Ray<double> ray = convert<double>(pixel_rays(x, y));
        ExactNearest nearest(scene, ray);
        neighbourhood.visit(ray, nearest);
        image.t[image.index(x, y)] = nearest.t();
        image.object[image.index(x, y)] = nearest.object();
      }
    }
  });
  return image;
}

}  // namespace

ExactHit exact_hit(const Scene& scene, ObjectIndex object, const Ray<double>& ray) {
  const Object& asked = scene.objects[object];
  const Case one{{}, scene.precision, {}, RayQuestion{ray, asked.shape, asked.transform}};
  const auto answer = std::get<RayAnswer>(oracle::answer(one));
  if (answer.hits.count == 0) return {};
  return {true, answer.hits.t[0]};
}

ObjectIndex exact_nearest_at(const Scene& scene, const Neighbourhood& neighbourhood, int x, int y) {
  const Ray<double> ray = pixel_ray(scene, x, y);
  ExactNearest nearest(scene, ray);
  neighbourhood.visit(ray, nearest);
  return nearest.object();
}

HitImage trace_exactly(const Scene& scene, const Neighbourhood& neighbourhood, const Work& work) {
  return scene.precision == Precision::float32 ? trace_exactly_in<float>(scene, neighbourhood, work)
                                               : trace_exactly_in<double>(scene, neighbourhood, work);
}

}  // namespace rayproof::render
