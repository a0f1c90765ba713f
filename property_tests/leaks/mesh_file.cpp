#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <new>
#include <stdexcept>
#include <tuple>

#include "case/reader/near_names.hpp"
#include "leaks/mesh.hpp"

namespace rayproof::leaks {

namespace {

using FilePoint = CGAL::Simple_cartesian<double>::Point_3;

/// Numbers vertices by their place: files without indices (STL) repeat them for each triangle.
class VertexNumbers {
 public:
  explicit VertexNumbers(ClosedMesh& mesh) : mesh_(mesh) {}

  std::size_t operator()(const FilePoint& p) {
    const auto [place, is_new] = numbers_.try_emplace(std::tuple(p.x(), p.y(), p.z()), mesh_.vertices.size());
    if (is_new) mesh_.vertices.emplace_back(p.x(), p.y(), p.z());
    return place->second;
  }

 private:
  ClosedMesh& mesh_;
  std::map<std::tuple<double, double, double>, std::size_t> numbers_{};
};

}  // namespace

ClosedMesh read_mesh(const std::string& file) {
  if (!std::filesystem::exists(file)) {
    const auto meant = likely_name(file, made_meshes());
    throw std::runtime_error(file + " does not exist" + (meant ? "; did you mean " + *meant + "?" : ""));
  }
  std::vector<FilePoint> points;
  std::vector<std::vector<std::size_t>> faces;
  bool is_read = false;
  try {
    is_read = CGAL::IO::read_polygon_soup(file, points, faces);
  } catch (const std::bad_alloc&) {  // the file's own counts are believed
    throw std::runtime_error(file + " asks for more memory than there is: are its counts right?");
  }
  if (!is_read || faces.empty())
    throw std::runtime_error(file + " is no mesh in OFF, OBJ, STL or PLY that can be read");
  for (const std::vector<std::size_t>& face : faces)
    for (const std::size_t corner : face)
      if (corner >= points.size())
        throw std::runtime_error(file + ": a face names a vertex that there is not");
  ClosedMesh mesh{.name = std::filesystem::path(file).stem().string()};
  VertexNumbers number_of(mesh);
  for (const std::vector<std::size_t>& face : faces)
    for (std::size_t k = 2; k < face.size(); ++k) {
      const std::array<std::size_t, 3> corners{
          number_of(points.at(face[0])), number_of(points.at(face[k - 1])), number_of(points.at(face[k]))};
      const auto& [a, b, c] = corners;
      if (a != b && b != c && c != a) mesh.triangles.push_back(corners);
    }
  if (mesh.triangles.empty()) throw std::runtime_error(file + ": no face has three corners that differ");
  for (const glm::dvec3& v : mesh.vertices)
    if (!std::isfinite(v.x + v.y + v.z)) throw std::runtime_error(file + ": a vertex is not finite");
  return turned_outward(std::move(mesh));
}

}  // namespace rayproof::leaks
