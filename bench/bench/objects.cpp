/// \file
/// The nearest hit among N small spheres or triangles in a cube, by plain and by exact methods: by a list, by
/// trees over it, and by Embree's own spheres and triangles (rtcIntersect1). Items per second are rays.

#include <benchmark/benchmark.h>

#include <rayproof/rayproof.hpp>
#include <string>
#include <utility>
#include <vector>

#include "bench/scenes/random_scene.hpp"
#ifdef RAYPROOF_HAS_EMBREE
#include <rayproof/objects/embree_tree.hpp>

#include "bench/scenes/embree_scene.hpp"
#endif

namespace {

using namespace rayproof;

constexpr std::size_t counts[] = {1, 3, 10, 30, 100, 1'000, 10'000, 100'000, 1'000'000};

/// Asks about each ray in turn by `is_hit(ray)`; says how many of them hit something.
template <class IsHit>
void time_rays(benchmark::State& state, const IsHit& is_hit) {
  const std::vector<Ray<float>> rays = report::rays_through_scene();
  std::size_t next = 0, hits = 0;
  for (auto _ : state) {
    hits += is_hit(rays[next]) ? 1 : 0;
    next = (next + 1) % rays.size();
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["hit_share"] = static_cast<double>(hits) / static_cast<double>(state.iterations());
}

template <class Choice>
ObjectList<float, Choice> list_of(const std::string& kind, std::size_t count) {
  ObjectList<float, Choice> list;
  const report::RandomScene scene = report::random_scene(kind, count);
  for (const auto& sphere : scene.spheres) list.add(sphere);
  for (const auto& triangle : scene.triangles) list.add(triangle);
  return list;
}

template <class Choice, class Search>
void add_tree(const std::string& name, const std::string& kind, std::size_t count) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    const ObjectTree<float, Choice, Search> tree(list_of<Choice>(kind, count));
    time_rays(state, [&](const Ray<float>& ray) { return tree.nearest(ray).has_value(); });
  });
}

template <class Choice>
void add_objects(const std::string& name, const std::string& kind) {
  for (const std::size_t count : counts) {
    const std::string end = name + "/" + std::to_string(count);
    if (count <= 1000)
      benchmark::RegisterBenchmark(("objects/list/" + end).c_str(), [=](benchmark::State& state) {
        const auto list = list_of<Choice>(kind, count);
        time_rays(state, [&](const Ray<float>& ray) { return list.nearest(ray).has_value(); });
      });
    add_tree<Choice, objects::BoundsTree>("objects/bounds_tree/" + end, kind, count);
#ifdef RAYPROOF_HAS_EMBREE
    add_tree<Choice, objects::EmbreeTree>("objects/embree_tree/" + end, kind, count);
#endif
  }
}

#ifdef RAYPROOF_HAS_EMBREE
void add_embree(const std::string& kind) {
  for (const std::size_t count : counts)
    benchmark::RegisterBenchmark(
        ("objects/embree/" + kind + "/" + std::to_string(count)).c_str(), [=](benchmark::State& state) {
          const report::EmbreeOnly scene(report::random_scene(kind, count));
          time_rays(state, [&](const Ray<float>& ray) { return scene.nearest(ray) < infinity<float>; });
        });
}
#endif

[[maybe_unused]] const bool objects_are_registered = [] {
  add_objects<PlainMethods>("spheres", "spheres");
  add_objects<ExactMethods>("spheres_exactly", "spheres");
  add_objects<PlainMethods>("triangles", "triangles");
  add_objects<ExactMethods>("triangles_exactly", "triangles");
#ifdef RAYPROOF_HAS_EMBREE
  add_embree("spheres");
  add_embree("triangles");
#endif
  return true;
}();

}  // namespace
