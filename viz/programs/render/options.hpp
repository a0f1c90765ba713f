#pragma once
/// \file
/// The command line of rayproof render.

#include <optional>
#include <string>
#include <vector>

#include "command_line/command_line.hpp"
#include "viz/programs/wrong_command.hpp"
#include "viz/render/scene/scene_reader.hpp"
#include "viz/render/shading.hpp"

namespace rayproof::render {

using viz::WrongCommand;

/// What is asked for.
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

}  // namespace rayproof::render
