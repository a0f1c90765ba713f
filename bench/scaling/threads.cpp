#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <memory>
#include <rayproof/rayproof.hpp>
#include <thread>

#include "bench/contenders/contender.hpp"
#include "bench/scaling/scaling.hpp"
#include "bench/scenes/random_scene.hpp"
#include "bench/scenes/ray_columns.hpp"
#include "generators/draw.hpp"

namespace rayproof::report {

namespace {

constexpr std::size_t ray_count = 1 << 18;

/// From all sides to points near the origin.
RayColumns rays_from_all_sides() {
  Random random(18);
  RayColumns rays;
  for (std::size_t i = 0; i < ray_count; ++i) {
    const glm::dvec3 origin = 4.0 * draw::unit_vector(random);
    rays.add({origin, 1.2 * random.unit() * draw::unit_vector(random) - origin});
  }
  return rays;
}

/// A pass in which `tile(from, size)` is called for parts of the rays, by this many threads.
template <class Tile>
Contender in_tiles(const char* name, Arrangement arrangement, std::size_t threads, const Tile& tile) {
  const auto arena = std::make_shared<tbb::task_arena>(static_cast<int>(threads));
  const auto pass = [arena, tile](std::size_t count) {
    constexpr std::size_t size = 1024;
    arena->execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, count, size),
          [&](const auto& part) { tile(part.begin(), part.size()); }, tbb::simple_partitioner{});
    });
  };
  return {name, arrangement, pass};
}

template <class Method, class Shape>
Contender batch_in_tiles(const char* name, const std::shared_ptr<const RayColumns>& rays, const Shape& shape,
                         std::size_t threads) {
  const auto t = std::make_shared<std::vector<float>>(rays->size());
  return in_tiles(name, Arrangement::batch, threads, [rays, t, shape](std::size_t from, std::size_t size) {
    nearest_hits<Method>(rays->part(from, size), shape, std::span(*t).subspan(from, size));
  });
}

Contender scene_in_tiles(const char* name, std::size_t threads) {
  ObjectList<float> list;
  for (const auto& sphere : random_scene("spheres", 10'000).spheres) list.add(sphere);
  const auto tree = std::make_shared<const ObjectTree<float>>(std::move(list));
  const auto rays = std::make_shared<const std::vector<Ray<float>>>(rays_through_scene());
  const auto hits = std::make_shared<std::vector<std::uint8_t>>(ray_count);
  return in_tiles(name, Arrangement::scalar, threads, [=](std::size_t from, std::size_t size) {
    for (std::size_t i = from; i < from + size; ++i)
      (*hits)[i] = tree->nearest((*rays)[i % rays->size()]).has_value() ? 1 : 0;
  });
}

std::vector<std::size_t> thread_counts() {
  const std::size_t all = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::size_t> counts;
  for (std::size_t n = 1; n < all; n *= 2) counts.push_back(n);
  counts.push_back(all);
  return counts;
}

}  // namespace

std::vector<ScalingStep> threads_scaling(const BenchOptions& options) {
  const double seconds = options.seconds;
  std::vector<ScalingStep> steps;
  for (const std::size_t threads : thread_counts()) {
    const auto measure = [seconds](const BenchRow& pattern) {
      const auto rays = std::make_shared<const RayColumns>(rays_from_all_sides());
      const Sphere<float> ball{{0, 0, 0}, 1};
      const Triangle<float> triangle{{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}};
      const std::vector<Contender> all{
          batch_in_tiles<sphere::Centred>("sphere/centred", rays, ball, pattern.size),
          batch_in_tiles<sphere::Rounded>("sphere/rounded", rays, ball, pattern.size),
          batch_in_tiles<triangle::Woop>("triangle/woop", rays, triangle, pattern.size),
          scene_in_tiles("tree_of_10000_spheres", pattern.size)};
      return timed_rows(all, pattern, ray_count, seconds, wall_seconds);
    };
    steps.push_back({{.shape = "rays", .family = "threads", .size = threads}, measure});
  }
  return steps;
}

}  // namespace rayproof::report
