/// \file
/// Rays at one shape: our kernels one ray at a time and in batches, GLM, and the floor of streaming the rays.
/// The time is that of one pass over all rays; items per second are rays.

#include <benchmark/benchmark.h>

#include <string>

#include "bench/figures/shape_passes.hpp"
#include "generators/generators.hpp"

namespace {

using namespace rayproof;

constexpr std::size_t ray_count = 65536;

/// The random family's rays at one shape, made once.
template <class Topic, template <class> class Shape, class T>
report::ShapeRays<Shape, T>& random_rays() {
  static report::ShapeRays<Shape, T> rays = [] {
    std::vector<Case> cases;
    for (const Family& family : families()) {
      if (family.topic != Topic::name || family.name != "random") continue;
      for (std::uint64_t seed = 0; seed < ray_count; ++seed)
        cases.push_back(family.generate(seed, sizeof(T) == 4 ? Precision::float32 : Precision::float64));
    }
    return report::ShapeRays<Shape, T>(cases);
  }();
  return rays;
}

template <class Topic, template <class> class Shape, class T, class Pass>
void add(const std::string& name, Pass pass) {
  benchmark::RegisterBenchmark(
      (std::string(Topic::name) + "/" + name + (sizeof(T) == 4 ? "/float" : "/double")).c_str(),
      [pass](benchmark::State& state) {
        auto& rays = random_rays<Topic, Shape, T>();
        for (auto _ : state) pass(rays);
        state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(ray_count));
      })
      ->Unit(benchmark::kMicrosecond);
}

template <class Topic, class T, template <class> class Shape>
void add_all(const RayTopic<Shape>* /*topic*/) {
  using Rays = report::ShapeRays<Shape, T>;
  if constexpr (report::is_in_glm<Shape, T>)
    add<Topic, Shape, T>("glm/scalar", [](Rays& rays) { report::hit_by_glm(rays, ray_count); });
  Topic::Methods::for_each([]<class Method>(std::type_identity<Method>) {
    const std::string name = Method::name;
    add<Topic, Shape, T>(name + "/scalar", [](Rays& r) { report::hit_one_by_one<Method>(r, ray_count); });
    if constexpr (batch::has_kernels<Method>)
      for (const InstructionSet set : available_instruction_sets())
        add<Topic, Shape, T>(name + "/" + std::string(name_of(set)),
                             [set](Rays& rays) { report::hit_in_batch<Method>(rays, ray_count, set); });
  });
  for (const InstructionSet set : available_instruction_sets())
    add<Topic, Shape, T>("streaming/" + std::string(name_of(set)),
                         [set](Rays& rays) { report::only_stream(rays, ray_count, set); });
}

[[maybe_unused]] const bool shapes_are_registered = [] {
  Topics::for_each([]<class Topic>(std::type_identity<Topic>) {
    if constexpr (is_batched<Topic> && !std::is_same_v<Topic, quadratic::Topic>) {
      add_all<Topic, float>(static_cast<const Topic*>(nullptr));
      add_all<Topic, double>(static_cast<const Topic*>(nullptr));
    }
  });
  return true;
}();

}  // namespace
