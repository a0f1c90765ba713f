#include "viz/render/tiles.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>

namespace rayproof::render {

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
