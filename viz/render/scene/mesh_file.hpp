#pragma once
/// \file
/// Meshes from files.

#include <filesystem>
#include <rayproof/triangle.hpp>
#include <stdexcept>
#include <vector>

namespace rayproof::render {

/// A file that can't be read or is no mesh; the text says so in one sentence that names the file.
class UnreadableFile : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The triangles of a file in OBJ, STL, PLY or OFF, unrounded; the end of its name says which. A face with
/// more than three corners becomes a fan. Throws UnreadableFile.
[[nodiscard]] std::vector<Triangle<double>> read_mesh(const std::filesystem::path& file);

}  // namespace rayproof::render
