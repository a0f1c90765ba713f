#pragma once
/// \file
/// The command line of rayproof render.

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "command_line/command_line.hpp"
#include "viz/programs/report_case.hpp"
#include "viz/render/hits.hpp"
#include "viz/render/scene/scene_reader.hpp"
#include "viz/render/shading.hpp"

namespace rayproof::render {

using viz::WrongCommand;

enum class Mode { picture, exact_picture, error, compare, pixel, shadows };

struct RenderOptions {
  std::string scene{}, out{}, precision{}, size{}, shade = "normal";
  std::vector<std::string> methods{}, error{}, compare{}, strategies{};
  std::vector<int> pixel{};
  bool is_exact = false, is_error = false, is_window = false;
  int jobs = 0;

  void add_to(CLI::App& app);

  /// Throws WrongCommand where the options do not go together.
  [[nodiscard]] Mode mode() const;
  [[nodiscard]] SceneOverrides overrides() const;
  [[nodiscard]] Shade shading() const { return shade == "flat" ? Shade::flat : Shade::normal; }
  /// The default methods, with --method's and then `more` in their places. Throws WrongCommand.
  [[nodiscard]] Methods chosen_methods(const std::vector<std::string>& more = {}) const;
};

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
