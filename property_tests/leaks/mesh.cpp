#include "leaks/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "case/each_number.hpp"
#include "generators/scene.hpp"

namespace rayproof::leaks {

namespace {

/// A grid of `around` by `along` points, closed both ways, each cell cut in two: a torus, however it winds.
ClosedMesh tube(const std::string& name, std::size_t around, std::size_t along, auto&& place) {
  ClosedMesh mesh{.name = name};
  for (std::size_t i = 0; i < along; ++i)
    for (std::size_t j = 0; j < around; ++j)
      mesh.vertices.push_back(
          place(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(along),
                2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(around)));
  const auto at = [&](std::size_t i, std::size_t j) { return (i % along) * around + j % around; };
  for (std::size_t i = 0; i < along; ++i)
    for (std::size_t j = 0; j < around; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

ClosedMesh torus() {
  return tube("torus", 24, 48, [](double u, double v) {
    const double r = 3 + std::cos(v);
    return glm::dvec3(r * std::cos(u), r * std::sin(u), std::sin(v));
  });
}

/// A trefoil. Its tube is not perpendicular to the curve, which does not matter here.
ClosedMesh knot() {
  return tube("knot", 16, 160, [](double u, double v) {
    const double r = 2 + std::cos(3 * u) + 0.4 * std::cos(v);
    return glm::dvec3(r * std::cos(2 * u), r * std::sin(2 * u), std::sin(3 * u) + 0.4 * std::sin(v));
  });
}

ClosedMesh cube() {
  ClosedMesh mesh{.name = "cube"};
  for (int corner = 0; corner < 8; ++corner)
    mesh.vertices.emplace_back(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
  for (const auto& [a, b, c, d] : std::array<std::array<std::size_t, 4>, 6>{
           {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}}) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}

/// The cube's triangles, each in four, three times over, and then blown up to a ball.
ClosedMesh sphere() {
  ClosedMesh mesh = cube();
  mesh.name = "sphere";
  for (int round = 0; round < 3; ++round) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b) {
      const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), mesh.vertices.size());
      if (is_new) mesh.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
      return place->second;
    };
    std::vector<std::array<std::size_t, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const auto& part : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        finer.push_back(part);
    }
    mesh.triangles = std::move(finer);
  }
  for (glm::dvec3& v : mesh.vertices) v /= std::sqrt(dot(v, v));
  return mesh;
}

}  // namespace

const std::vector<std::string>& made_meshes() {
  static const std::vector<std::string> names{"cube", "sphere", "torus", "knot"};
  return names;
}

ClosedMesh make_mesh(const std::string& name) {
  if (name == "cube") return turned_outward(cube());
  if (name == "sphere") return turned_outward(sphere());
  return turned_outward(name == "torus" ? torus() : knot());
}

ClosedMesh turned_outward(ClosedMesh mesh) {
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    volume += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c]));
  if (volume < 0)
    for (auto& corners : mesh.triangles) std::swap(corners[1], corners[2]);
  return mesh;
}

ClosedMesh rounded(ClosedMesh mesh, Precision precision) {
  const int largest = precision == Precision::float32 ? 60 : 500;
  for (glm::dvec3& v : mesh.vertices) {
    const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (size > std::ldexp(1.0, largest))
      throw std::runtime_error(
          fmt::format("the mesh {} has a coordinate of size {}: in {} lengths are judged up to 2^{}",
                      mesh.name, size, name_of(precision), largest));
    v = rayproof::rounded(precision, v);
  }
  return mesh;
}

Topology topology_of(const ClosedMesh& mesh) {
  Topology topology;
  topology.around.resize(mesh.vertices.size());
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> side_of;
  for (std::size_t number = 0; number < mesh.triangles.size(); ++number)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& corners = mesh.triangles[number];
      topology.around[corners[k]].push_back(number);
      if (!side_of.try_emplace({corners[k], corners[(k + 1) % 3]}, number).second)
        throw std::runtime_error(
            fmt::format("the mesh {} is not closed and oriented: the edge from vertex {} to vertex {} has "
                        "two triangles on one side",
                        mesh.name, corners[k], corners[(k + 1) % 3]));
    }
  for (const auto& [edge, triangle] : side_of) {
    const auto other = side_of.find({edge.second, edge.first});
    if (other == side_of.end())
      throw std::runtime_error(fmt::format(
          "the mesh {} is not closed: the edge from vertex {} to vertex {} has a triangle on one side alone",
          mesh.name, edge.first, edge.second));
    if (edge.first > edge.second) continue;
    topology.edges.push_back({edge.first, edge.second});
    topology.beside.push_back({triangle, other->second});
  }
  return topology;
}

}  // namespace rayproof::leaks
