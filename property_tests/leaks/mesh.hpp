#pragma once
/// \file
/// A closed mesh of triangles: read from a file or made, and what of it lies where.

#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace rayproof::leaks {

/// Vertices, and triangles as indices into them, counter-clockwise as seen from outside.
struct ClosedMesh {
  std::string name{};
  std::vector<glm::dvec3> vertices{};
  std::vector<std::array<std::size_t, 3>> triangles{};

  [[nodiscard]] Triangle<double> triangle(std::size_t number) const {
    const auto& [a, b, c] = triangles[number];
    return {vertices[a], vertices[b], vertices[c]};
  }
};

/// The triangles of a file in OFF, OBJ, STL or PLY. Larger faces are split into fans, vertices at one place
/// become one. Throws std::runtime_error with a sentence that names the file.
[[nodiscard]] ClosedMesh read_mesh(const std::string& file);

/// The meshes that need no file: "cube", "sphere", "torus", "knot".
[[nodiscard]] const std::vector<std::string>& made_meshes();
[[nodiscard]] ClosedMesh make_mesh(const std::string& name);

/// The mesh with its triangles turned round if they wind clockwise as seen from outside.
[[nodiscard]] ClosedMesh turned_outward(ClosedMesh mesh);

/// The mesh with its numbers rounded to a precision, which moves its vertices but tears nothing apart. Throws
/// std::runtime_error where they are so large that products of lengths may overflow.
[[nodiscard]] ClosedMesh rounded(ClosedMesh mesh, Precision precision);

/// The neighbourhoods in a mesh.
struct Topology {
  std::vector<std::vector<std::size_t>> around;    ///< of each vertex: the triangles that share it
  std::vector<std::array<std::size_t, 2>> edges;   ///< the vertices of each edge, once
  std::vector<std::array<std::size_t, 2>> beside;  ///< of each edge: the triangles on its two sides
};

/// Throws std::runtime_error where the mesh is not closed: each edge must have one triangle on either side.
[[nodiscard]] Topology topology_of(const ClosedMesh& mesh);

}  // namespace rayproof::leaks
