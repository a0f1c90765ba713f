#pragma once
/// \file
/// Pixels: what a sink writes to a file.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rayproof::viz {

using Rgb = std::array<std::uint8_t, 3>;

/// "#rrggbb" as three bytes.
[[nodiscard]] constexpr Rgb rgb_of(const char* hex) {
  const auto digit = [](char c) {
    return static_cast<std::uint8_t>(c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10);
  };
  Rgb rgb{};
  for (std::size_t i = 0; i < 3; ++i)
    rgb[i] = static_cast<std::uint8_t>(16 * digit(hex[1 + 2 * i]) + digit(hex[2 + 2 * i]));
  return rgb;
}

/// An image of 8-bit RGB pixels, by rows from the top.
struct Raster {
  int width = 0;
  int height = 0;
  std::vector<Rgb> pixels{};

  Raster() = default;
  Raster(int w, int h, Rgb colour)
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), colour) {}

  [[nodiscard]] Rgb& at(int x, int y) {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  [[nodiscard]] const Rgb& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

}  // namespace rayproof::viz
