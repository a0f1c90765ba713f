/// \file
/// Leaving surfaces in batches: from the hit to the origin of the next ray by the proven offset, the move
/// onto the surface and the bounds included. Items per second are hits.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <rayproof/spawn.hpp>
#include <rayproof/spawn/batch.hpp>
#include <string>
#include <vector>

#include "generators/random.hpp"

namespace {

using namespace rayproof;

constexpr std::size_t hit_count = 4096;

/// Hits about a shape of size 1, and the sides to which they are left.
template <class T>
struct BenchHits {
  std::vector<T> x, y, z, side, to_x, to_y, to_z;

  BenchHits() {
    Random random(14);
    const auto draw = [&](std::vector<T>& column) {
      for (std::size_t i = 0; i < hit_count; ++i) column.push_back(static_cast<T>(random.uniform(-1, 1)));
    };
    for (auto* column : {&x, &y, &z, &side}) draw(*column);
    for (auto* column : {&to_x, &to_y, &to_z}) column->resize(hit_count);
  }
};

template <class T>
glm::mat<4, 4, T> some_map() {
  glm::mat<4, 4, T> map(T(1));
  map[1][0] = T(0.3);
  map[3] = {T(1), T(-2), T(3), T(1)};
  return map;
}

template <class T, class Shape>
void add_spawn(const std::string& shape_name, const Shape& shape) {
  const auto surface = spawn::surface_of(shape);
  for (const bool is_moved : {false, true})
    for (const InstructionSet set : available_instruction_sets()) {
      const std::string name = "spawn/proven/" + shape_name + (is_moved ? "/transformed/" : "/") +
                               std::string(name_of(set)) + (sizeof(T) == 4 ? "/float" : "/double");
      benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        BenchHits<T> hits;
        std::optional<spawn::Placement<T>> map;
        if (is_moved) map = spawn::placement<T>(some_map<T>());
        for (auto _ : state)
          spawn::next_origins<spawn::Proven>(surface, {hits.x, hits.y, hits.z}, hits.side,
                                             {hits.to_x, hits.to_y, hits.to_z}, map, set);
        state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(hit_count));
      });
    }
}

template <class T>
void add_all_spawns() {
  add_spawn<T>("triangle", Triangle<T>{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}});
  add_spawn<T>("sphere", Sphere<T>{{0, 0, 0}, 1});
  add_spawn<T>("box", Box<T>{{0, 0, 0}, {1, 1, 1}});
  add_spawn<T>("parallelepiped",
               Parallelepiped<T>{{0, 0, 0}, {vec3<T>{1, 0, 0}, vec3<T>{T(0.5), 1, 0}, vec3<T>{0, 0, 1}}});
  add_spawn<T>("cylinder", Cylinder<T>{1, 2, 1, true});
}

[[maybe_unused]] const bool spawn_is_registered = (add_all_spawns<float>(), add_all_spawns<double>(), true);

}  // namespace
