#include "viz/render/shading.hpp"

#include <algorithm>
#include <cmath>
#include <rayproof/spawn.hpp>

#include "subjects/reading.hpp"
#include "viz/render/errors.hpp"
#include "viz/render/figures.hpp"
#include "viz/render/hits.hpp"

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

/// Where a ray has hit an object, for the next ray.
template <class T>
spawn::SurfacePoint<T> surface_point_of(const Object& object, const Ray<T>& ray, T t) {
  const auto leave = [&](const auto& given) -> spawn::SurfacePoint<T> {
    const auto shape = convert<T>(library_shape(given));
    if constexpr (spawn::can_be_left<decltype(shape)>) {
      const auto surface = spawn::surface_of(shape);
      const vec3<T> p = point_at(ray, t);
      if (!object.transform) return spawn::leave(surface, p);
      return spawn::leave(surface, spawn::placement(glm::mat<4, 4, T>(*object.transform)), p);
    } else {
      throw std::runtime_error("a shape of this scene can't be left: see spawn/surfaces.hpp");
    }
  };
  return std::visit(leave, object.shape);
}

template <class Strategy, class T>
class ShadowRays {
 public:
  ShadowRays(const RenderScene& scene, const Methods& methods)
      : scene_(scene), figures_(scene, methods), light_(convert<T>(*scene.light)) {}

  /// Whether the light is seen from the nearest hit of the ray, and how squarely it falls; nothing where the
  /// ray hits nothing.
  struct LightSeen {
    bool is_hit = false, is_lit = false;
    double cosine = 0;
  };
  [[nodiscard]] LightSeen seen_along(const Ray<T>& ray) const {
    const Nearest<T> hit = meet<T>(figures_, nullptr, std::span(&ray, 1)).front();
    if (hit.object == no_object) return {};
    spawn::SurfacePoint<T> from = surface_point_of(scene_.objects[hit.object], ray, hit.t);
    const vec3<T> towards_light = light_ - from.point;
    const T fall = dot(from.normal, towards_light);
    const bool is_seen_from_front = dot(from.normal, ray.direction) < 0;
    turn(from, is_seen_from_front ? T(1) : T(-1));
    if ((fall > 0) != is_seen_from_front) return {true, false, 0};  // the light is behind the surface
    const vec3<T> origin = Strategy::origin(from);
    const Ray<T> shadow_ray{origin, light_ - origin, T(0), T(1)};
    const bool is_lit = meet<T>(figures_, nullptr, std::span(&shadow_ray, 1)).front().object == no_object;
    const double cosine = static_cast<double>(std::abs(fall) / std::sqrt(dot(towards_light, towards_light)));
    return {true, is_lit, cosine};
  }

 private:
  const RenderScene& scene_;
  AllFigures<T> figures_;
  vec3<T> light_;
};

template <class Strategy, class T>
LightImage light_up_in(const RenderScene& scene, const Methods& methods, const Work& work) {
  const std::size_t count = viz::pixel_index(scene.width, 0, scene.height);
  LightImage image{scene.width, scene.height, std::vector<Lighting>(count), std::vector<double>(count)};
  const ShadowRays<Strategy, T> claimed(scene, methods);
  const ShadowRays<spawn::Proven, double> exact(scene, methods);
  const PixelRays<T> pixel_rays(scene);
  for_each_pixel(scene.width, scene.height, work, [&](int x, int y) {
    const std::size_t i = viz::pixel_index(scene.width, x, y);
    const Ray<T> ray = pixel_rays(x, y);
    const auto seen = claimed.seen_along(ray);
    image.cosine[i] = seen.cosine;
    if (!seen.is_hit) return;
    const bool is_lit = exact.seen_along(convert<double>(ray)).is_lit;
    image.pixels[i] = seen.is_lit == is_lit ? (is_lit ? Lighting::lit : Lighting::shadow)
                      : is_lit              ? Lighting::acne
                                            : Lighting::leak;
  });
  const auto count_of = [&](Lighting kind) {
    return static_cast<std::size_t>(std::ranges::count(image.pixels, kind));
  };
  image.acne = count_of(Lighting::acne);
  image.leaks = count_of(Lighting::leak);
  return image;
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

std::vector<std::string> strategy_names() {
  std::vector<std::string> names;
  spawn::Strategies::for_each([&]<class S>(std::type_identity<S>) { names.emplace_back(S::name); });
  return names;
}

LightImage light_up(const RenderScene& scene, const std::string& strategy, const Methods& methods,
                    const Work& work) {
  LightImage image;
  spawn::Strategies::for_each([&]<class S>(std::type_identity<S>) {
    if (strategy != S::name) return;
    image =
        in_precision(scene.precision, [&]<class T>(T) { return light_up_in<S, T>(scene, methods, work); });
  });
  return image;
}

viz::Raster shaded(const RenderScene& scene, const LightImage& light, const HitImage& hits) {
  constexpr double in_shadow = 0.3;
  viz::Raster raster(light.width, light.height, background);
  for (std::size_t i = 0; i < light.pixels.size(); ++i) {
    if (hits.object[i] == no_object) continue;
    const Rgb colour = object_colours[scene.objects[hits.object[i]].entry % object_colours.size()];
    const Lighting pixel = light.pixels[i];
    raster.pixels[i] = pixel == Lighting::acne   ? rgb_of("#e4002b")
                       : pixel == Lighting::leak ? rgb_of("#fff000")
                       : pixel == Lighting::lit  ? dimmed(colour, 0.55 + 0.45 * light.cosine[i])
                                                 : dimmed(colour, in_shadow);
  }
  return raster;
}

}  // namespace rayproof::render
