#pragma once
/// \file
/// An image cut into tiles for the threads.

#include "viz/render/hits.hpp"

namespace rayproof::render {

/// Pixels (x, y) with left <= x < right and top <= y < bottom.
struct Tile {
  int left, top, right, bottom;
};

inline constexpr int tile_side = 32;

/// The tiles of an image by rows: every pixel is in one of them, and in only one.
[[nodiscard]] std::vector<Tile> tiles_of(int width, int height);

/// Calls `body(x, y)` for each pixel of a tile, by rows.
template <class Body>
void for_each_pixel(const Tile& tile, Body&& body) {
  for (int y = tile.top; y < tile.bottom; ++y) {
    for (int x = tile.left; x < tile.right; ++x) body(x, y);
  }
}

/// Calls `body` for each tile, on several threads. Throws Stopped.
void for_each_tile(int width, int height, const Work& work, const std::function<void(const Tile&)>& body);

/// Calls `body(x, y)` for each pixel of an image, tile by tile.
template <class Body>
void for_each_pixel(int width, int height, const Work& work, Body&& body) {
  for_each_tile(width, height, work, [&](const Tile& tile) { for_each_pixel(tile, body); });
}

}  // namespace rayproof::render
