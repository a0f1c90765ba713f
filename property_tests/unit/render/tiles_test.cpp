#include "viz/render/hits.hpp"

#include <gtest/gtest.h>

namespace rayproof::render {
namespace {

TEST(Tiles, CoverEveryPixelOnce) {
  for (const auto& [width, height] :
       {std::pair(1, 1), std::pair(32, 32), std::pair(33, 31), std::pair(100, 7), std::pair(1, 97)}) {
    std::vector<int> covered(static_cast<std::size_t>(width * height));
    for (const Tile& tile : tiles_of(width, height)) {
      EXPECT_LE(tile.right, width);
      EXPECT_LE(tile.bottom, height);
      for_each_pixel(tile,
                     [&, row = width](int x, int y) { ++covered[static_cast<std::size_t>(y * row + x)]; });
    }
    EXPECT_EQ(covered, std::vector<int>(covered.size(), 1)) << width << 'x' << height;
  }
}

TEST(Tiles, ReportAllTheWorkAndEndWhenStopped) {
  double reported = 0;
  std::atomic<bool> stop = false;
  Work work{1, &stop, [&](double done) { reported = done; }};
  std::atomic<int> tiles = 0;
  for_each_tile(200, 100, work, [&](const Tile&) { ++tiles; });
  EXPECT_EQ(tiles, 28);
  EXPECT_EQ(reported, 1);
  const auto stop_at_third = [&](const Tile&) { stop = ++tiles == 31; };
  EXPECT_THROW(for_each_tile(200, 100, work, stop_at_third), Stopped);
  EXPECT_EQ(tiles, 31);
}

}  // namespace
}  // namespace rayproof::render
