#pragma once
/// \file
/// VTK as a reader of meshes.

#include <filesystem>
#include <functional>
#include <optional>
#include <rayproof/triangle.hpp>
#include <vector>

namespace rayproof::render {

/// The triangles of an OBJ, STL, PLY (by VTK's readers) or OFF file, by the end of its name; polygons are cut
/// into triangles. Throws UnreadableFile with one sentence that names the file.
[[nodiscard]] std::vector<Triangle<double>> read_mesh(const std::filesystem::path& file);

/// What `make` gives, made in a child process that ends with it; nothing where it throws, crashes, or takes
/// more than a minute of processor time. What the child says on standard error is lost. Call it before there
/// are other threads.
[[nodiscard]] std::optional<std::vector<Triangle<double>>> made_apart(
    const std::function<std::vector<Triangle<double>>()>& make);

}  // namespace rayproof::render
