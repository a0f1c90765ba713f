#pragma once
/// \file
/// VTK as a reader of meshes.

#include <filesystem>
#include <rayproof/triangle.hpp>
#include <vector>

namespace rayproof::render {

/// The triangles of an OBJ, STL, PLY (by VTK's readers) or OFF file, by the end of its name; polygons are cut
/// into triangles. Throws UnreadableFile with one sentence that names the file.
[[nodiscard]] std::vector<Triangle<double>> read_mesh(const std::filesystem::path& file);

}  // namespace rayproof::render
