#pragma once
/// \file
/// Reads a scene from a JSON file: `camera`, `size`, `precision` and `shapes` (docs/raycasting.md).

#include <filesystem>

#include "viz/render/scene/mesh_file.hpp"
#include "viz/render/scene/scene.hpp"

namespace rayproof::render {

/// What the command line says in place of the file.
struct SceneOverrides {
  std::optional<Precision> precision{};
  std::optional<std::pair<int, int>> size{};  ///< width and height
};

/// No image is larger than this on either side.
inline constexpr int largest_side = 16384;

/// Reads the scene, its numbers rounded to its precision; meshes lie beside the scene's file unless their
/// path is absolute. Throws UnreadableFile, or a Refusal whose sentence names the file, the field and its
/// value.
[[nodiscard]] RenderScene read_scene(const std::filesystem::path& file, const SceneOverrides& overrides = {});

}  // namespace rayproof::render
