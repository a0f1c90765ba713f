#include "viz/render/scene/mesh_file.hpp"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>

namespace rayproof::render {
namespace {

using FilePoint = CGAL::Simple_cartesian<double>::Point_3;

bool is_known(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".obj" || ending == ".stl" || ending == ".ply" || ending == ".off";
}

/// Throws whatever the standard library does where the file does not hold together.
std::vector<Triangle<double>> triangles_in(const std::filesystem::path& file) {
  std::vector<FilePoint> points;
  std::vector<std::vector<std::size_t>> faces;
  if (!CGAL::IO::read_polygon_soup(file.string(), points, faces)) throw std::runtime_error("no mesh");
  const auto vertex = [&](std::size_t index) {
    const FilePoint& p = points.at(index);
    return glm::dvec3(p.x(), p.y(), p.z());
  };
  std::vector<Triangle<double>> triangles;
  for (const std::vector<std::size_t>& face : faces)
    for (std::size_t k = 2; k < face.size(); ++k)
      triangles.push_back({vertex(face[0]), vertex(face[k - 1]), vertex(face[k])});
  return triangles;
}

}  // namespace

std::vector<Triangle<double>> read_mesh(const std::filesystem::path& file) {
  const std::string name = file.string();
  if (std::filesystem::is_directory(file) || !std::ifstream(file))
    throw UnreadableFile(fmt::format("the file {} can't be read", name));
  if (!is_known(file)) {
    throw UnreadableFile(
        fmt::format("{} is no mesh that can be read: its name must end in .obj, .stl, .ply or .off", name));
  }
  std::vector<Triangle<double>> triangles;
  try {
    triangles = triangles_in(file);
  } catch (const std::exception&) {
    throw UnreadableFile(fmt::format("{} is no well-formed mesh file", name));
  }
  if (triangles.empty()) throw UnreadableFile(fmt::format("{} holds no triangle", name));
  return triangles;
}

}  // namespace rayproof::render
