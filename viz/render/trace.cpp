#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <mutex>

#include "case/case.hpp"
#include "oracle/oracle.hpp"
#include "viz/render/figures.hpp"
#include "viz/render/hits.hpp"

namespace rayproof::render {

namespace {

template <class T>
HitImage trace_in(const RenderScene& scene, const Methods& methods, const Neighbourhood& neighbourhood,
                  const Work& work) {
  HitImage image(scene.width, scene.height);
  const AllFigures<T> figures(scene, methods);
  const PixelRays<T> pixel_rays(scene);
  for_each_tile(scene.width, scene.height, work, [&](const Tile& tile) {
    std::vector<Ray<T>> rays;
    for_each_pixel(tile, [&](int x, int y) { rays.push_back(pixel_rays(x, y)); });
    const std::vector<Nearest<T>> nearest = meet<T>(figures, neighbourhood, rays);
    std::size_t next = 0;
    for_each_pixel(tile, [&](int x, int y) { image.set(x, y, nearest[next++]); });
  });
  return image;
}

/// Asks the objects near the ray one after another, keeping the nearest.
Nearest<double> exact_nearest(const RenderScene& scene, const Neighbourhood& neighbourhood,
                              const Ray<double>& ray) {
  Nearest<double> nearest;
  auto ask = [&](ObjectIndex object) {
    const ExactHit hit = exact_hit(scene, object, ray);
    if (hit.is_hit) nearest.take(hit.t, object);
    return beyond_rounding(nearest.t);
  };
  neighbourhood(ray, ask);
  return nearest;
}

}  // namespace

Methods default_methods() {
  Methods chosen;
  for (const FigureKind& kind : figure_kinds()) chosen[kind.shape] = kind.default_method;
  return chosen;
}

std::vector<std::string> renderable_methods() {
  std::vector<std::string> names;
  for (const FigureKind& kind : figure_kinds())
    for (const std::string& method : kind.methods) names.push_back(kind.shape + "/" + method);
  return names;
}

HitImage trace(const RenderScene& scene, const Methods& methods, const Neighbourhood& neighbourhood,
               const Work& work) {
  return in_precision(scene.precision,
                      [&]<class T>(T) { return trace_in<T>(scene, methods, neighbourhood, work); });
}

ObjectIndex nearest_at(const RenderScene& scene, const Methods& methods, const Neighbourhood& neighbourhood,
                       int x, int y) {
  return in_precision(scene.precision, [&]<class T>(T) {
    const std::array<Ray<T>, 1> ray{PixelRays<T>(scene)(x, y)};
    return meet<T>(AllFigures<T>(scene, methods), neighbourhood, ray).front().object;
  });
}

Ray<double> pixel_ray(const RenderScene& scene, int x, int y) {
  return in_precision(scene.precision,
                      [&]<class T>(T) { return convert<double>(PixelRays<T>(scene)(x, y)); });
}

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

std::vector<Tile> tiles_of(int width, int height) {
  std::vector<Tile> tiles;
  for (int top = 0; top < height; top += tile_side) {
    for (int left = 0; left < width; left += tile_side)
      tiles.push_back({left, top, std::min(left + tile_side, width), std::min(top + tile_side, height)});
  }
  return tiles;
}

void for_each_tile(int width, int height, const Work& work, const std::function<void(const Tile&)>& body) {
  const std::vector<Tile> tiles = tiles_of(width, height);
  const auto is_stopped = [&work] { return work.stop != nullptr && *work.stop; };
  std::atomic<std::size_t> done = 0;
  std::mutex reporting;
  const auto run = [&](std::size_t i) {
    if (is_stopped()) return;
    body(tiles[i]);
    const std::size_t now = ++done;
    const std::unique_lock<std::mutex> turn(reporting, std::try_to_lock);
    if (turn && work.progress) work.progress(static_cast<double>(now) / static_cast<double>(tiles.size()));
  };
  const int jobs = work.jobs > 0 ? work.jobs : tbb::task_arena::automatic;
  // More threads than cores only where they are asked for.
  const tbb::global_control threads(
      tbb::global_control::max_allowed_parallelism,
      static_cast<std::size_t>(std::max(work.jobs, tbb::this_task_arena::max_concurrency())));
  tbb::task_arena arena(jobs);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, tiles.size(), run, tbb::simple_partitioner()); });
  if (is_stopped()) throw Stopped();
}

}  // namespace rayproof::render
