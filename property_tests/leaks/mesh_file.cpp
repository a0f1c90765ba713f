#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <new>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "case/memory_bound.hpp"
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

struct PolygonSoup {
  std::vector<FilePoint> points{};
  std::vector<std::vector<std::size_t>> faces{};
};

/// Elements without a property take no room in a PLY file: CGAL would count through as many as the header
/// says.
void check_announced(const std::string& file, std::uintmax_t size) {
  std::ifstream in(file, std::ios::binary);
  std::string line, word, name;
  std::getline(in, line);
  if (!line.starts_with("ply")) return;
  while (std::getline(in, line) && !line.starts_with("end_header")) {
    double count = 0;
    if (!(std::istringstream(line) >> word >> name >> count) || word != "element") continue;
    if (count > static_cast<double>(size))
      throw std::runtime_error(fmt::format(
          "{} announces {:g} elements \"{}\", for which its {} bytes have no room", file, count, name, size));
  }
}

/// The file's own counts are believed.
std::runtime_error too_large(const std::string& file) {
  return std::runtime_error(file + " asks for more memory than its size allows: are its counts right?");
}

PolygonSoup read_soup(const std::string& file) {
  if (!std::filesystem::exists(file)) {
    const auto meant = likely_name(file, made_meshes());
    throw std::runtime_error(file + " does not exist" + (meant ? "; did you mean " + *meant + "?" : ""));
  }
  // A pipe or a device may never end.
  if (!std::filesystem::is_regular_file(file))
    throw std::runtime_error(file + " is no file that holds a mesh");
  const std::uintmax_t size = std::filesystem::file_size(file);
  check_announced(file, size);
  PolygonSoup soup;
  try {
    const MemoryBound bound(memory_for_mesh(size));
    if (CGAL::IO::read_polygon_soup(file, soup.points, soup.faces) && !soup.faces.empty()) return soup;
  } catch (const std::bad_alloc&) {
    throw too_large(file);
  } catch (const std::length_error&) {
    throw too_large(file);
  }
  throw std::runtime_error(file + " is no mesh in OFF, OBJ, STL or PLY that can be read");
}

}  // namespace

ClosedMesh read_mesh(const std::string& file) {
  const auto [points, faces] = read_soup(file);
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
