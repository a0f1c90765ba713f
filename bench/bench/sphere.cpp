/// \file
/// Ray/sphere: our kernels one ray at a time and in batches, GLM, and the floor of streaming the rays. The
/// time is that of one pass over all rays; items per second are rays.

#include <benchmark/benchmark.h>

#include <string>

#include "bench/figures/sphere_passes.hpp"
#include "generators/generators.hpp"

namespace {

using namespace rayproof;

constexpr std::size_t ray_count = 65536;

/// The random family's rays at one sphere, made once.
template <class T>
report::SphereRays<T>& random_rays() {
  static report::SphereRays<T> rays = [] {
    std::vector<Case> cases;
    for (const Family& family : families()) {
      if (family.topic != "sphere" || family.name != "random") continue;
      for (std::uint64_t seed = 0; seed < ray_count; ++seed)
        cases.push_back(family.generate(seed, sizeof(T) == 4 ? Precision::float32 : Precision::float64));
    }
    return report::SphereRays<T>(cases);
  }();
  return rays;
}

template <class T, class Pass>
void add(const std::string& name, Pass pass) {
  benchmark::RegisterBenchmark(
      (name + (sizeof(T) == 4 ? "/float" : "/double")).c_str(),
      [pass](benchmark::State& state) {
        report::SphereRays<T>& rays = random_rays<T>();
        for (auto _ : state) pass(rays);
        state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(ray_count));
      })
      ->Unit(benchmark::kMicrosecond);
}

template <class T>
void add_all() {
  using Rays = report::SphereRays<T>;
  add<T>("sphere/glm/scalar", [](Rays& rays) { report::hit_by_glm(rays, ray_count); });
  sphere::Topic::Methods::for_each([]<class Method>(std::type_identity<Method>) {
    const std::string name = "sphere/" + std::string(Method::name);
    add<T>(name + "/scalar", [](Rays& rays) { report::hit_one_by_one<Method>(rays, ray_count); });
    for (const InstructionSet set : available_instruction_sets())
      add<T>(name + "/" + std::string(name_of(set)),
             [set](Rays& rays) { report::hit_in_batch<Method>(rays, ray_count, set); });
  });
  for (const InstructionSet set : available_instruction_sets())
    add<T>("sphere/streaming/" + std::string(name_of(set)),
           [set](Rays& rays) { report::only_stream(rays, ray_count, set); });
}

[[maybe_unused]] const bool sphere_is_registered = (add_all<float>(), add_all<double>(), true);

}  // namespace
