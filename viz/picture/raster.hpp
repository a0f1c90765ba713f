#pragma once
/// \file
/// Pixels: what a sink writes to a file.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rayproof::viz {

using Rgb = std::array<std::uint8_t, 3>;

[[nodiscard]] constexpr Rgb rgb_of(const char* hex) {
  const auto digit = [](char c) {
    return static_cast<std::uint8_t>(c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10);
  };
  Rgb rgb{};
  for (std::size_t i = 0; i < 3; ++i)
    rgb[i] = static_cast<std::uint8_t>(16 * digit(hex[1 + 2 * i]) + digit(hex[2 + 2 * i]));
  return rgb;
}

/// Where a pixel stands in an image of that width, by rows from the top.
[[nodiscard]] constexpr std::size_t pixel_index(int width, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

/// An image of 8-bit RGB pixels, by rows from the top.
struct Raster {
  int width = 0;
  int height = 0;
  std::vector<Rgb> pixels{};

  Raster() = default;
  Raster(int w, int h, Rgb colour) : width(w), height(h), pixels(pixel_index(w, 0, h), colour) {}

  [[nodiscard]] Rgb& at(int x, int y) { return pixels[pixel_index(width, x, y)]; }
  [[nodiscard]] const Rgb& at(int x, int y) const { return pixels[pixel_index(width, x, y)]; }
};

}  // namespace rayproof::viz
