#pragma once
/// \file
/// Reads a scene from a JSON file: `camera`, `size`, `precision` and `shapes` (docs/raycasting.md).

#include <filesystem>
#include <functional>
#include <rayproof/triangle.hpp>
#include <stdexcept>
#include <vector>

#include "case/json/text.hpp"
#include "case/reader/field.hpp"
#include "viz/render/scene/scene.hpp"

namespace rayproof::render {

/// A file that can't be read or is no mesh; the text says so in one sentence that names the file.
class UnreadableFile : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The triangles of a mesh file, unrounded. Throws UnreadableFile.
using ReadMesh = std::function<std::vector<Triangle<double>>(const std::filesystem::path&)>;

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
[[nodiscard]] RenderScene read_scene(const std::filesystem::path& file, const ReadMesh& read_mesh,
                                     const SceneOverrides& overrides = {});

/// The camera of an object with `eye`, `center`, `up`, `fov_x` and `fov_y`, rounded to the precision, in
/// which its axes are sure to be numbers. Throws Refusal.
[[nodiscard]] Camera<double> read_camera(const Field& object, Precision precision);

/// The text at a path as `Field::path` writes it ("shapes[3].shape.radius"), shortened where it is long;
/// empty for an object, and where nothing stands there.
[[nodiscard]] std::string value_at(const json::Document& document, std::string_view path);

/// The triangles of an OFF file ("OFF", the numbers of vertices, faces and edges, the vertices, the faces; #
/// begins a comment; what follows a vertex's or face's numbers on its line, a colour say, is passed over). A
/// face with more than three corners becomes a fan. Throws UnreadableFile with file and line.
[[nodiscard]] std::vector<Triangle<double>> read_off(const std::filesystem::path& file);

}  // namespace rayproof::render
