#pragma once
/// \file
/// What rayproof render does: one run, and a pixel as a case to print and as a page to look at.

#include <atomic>
#include <string>

#include "viz/programs/render/options.hpp"
#include "viz/render/pixel_case.hpp"

namespace rayproof::render {

/// The case of a pixel and the method that answered there, "sphere/textbook".
struct PixelReport {
  Case one{};
  std::string method{};
};

/// Throws WrongCommand where the pixel is outside the image, or its ray meets nothing, so that there is no
/// case.
[[nodiscard]] PixelReport report_pixel(const RenderScene& scene, int x, int y, const Methods& methods);

/// Writes the method's walkthrough of the case as a page. Needs a display (viz::OffscreenDisplay). Throws
/// WrongCommand where the file can't be written.
void write_page(const PixelReport& report, const std::string& path);

/// Reads the scene and does what the options ask for. Throws Stopped once `stop` is true, a Refusal, or a
/// std::runtime_error.
void run(const RenderOptions& options, const std::atomic<bool>& stop);

}  // namespace rayproof::render
