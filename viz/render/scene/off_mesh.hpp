#pragma once
/// \file
/// Meshes in the Object File Format, which VTK 9.1 does not read.

#include <filesystem>
#include <rayproof/triangle.hpp>
#include <vector>

namespace rayproof::render {

/// The triangles of an OFF file ("OFF", the numbers of vertices, faces and edges, the vertices, the faces; #
/// begins a comment; what follows a vertex's or face's numbers on its line, a colour say, is passed over). A
/// face with more than three corners becomes a fan. Throws UnreadableFile with file and line.
[[nodiscard]] std::vector<Triangle<double>> read_off(const std::filesystem::path& file);

}  // namespace rayproof::render
