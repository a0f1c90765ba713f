#pragma once
/// \file
/// Rays aimed at a mesh's own vertices and edges, where a method may lose them.

#include <optional>

#include "leaks/mesh.hpp"

namespace rayproof::leaks {

/// What a ray is aimed at. A diagonal is an edge between two triangles of one plane.
enum class AimedAt { vertex, midpoint, edge, diagonal };
inline constexpr std::array<const char*, 4> target_names{"vertices", "midpoints", "edges", "diagonals"};
inline constexpr std::size_t target_count = target_names.size();

/// A ray, and the triangles near its target: the whole of the mesh that it can meet there.
struct Aim {
  AimedAt target{};
  bool from_inside = false;  ///< it comes from the inner side of the surface
  Ray<double> ray{};
  std::vector<std::size_t> patch{};  ///< numbers of triangles; all face the ray, or all turn their back to it
};

/// Where rays may be aimed at.
struct Targets {
  const ClosedMesh* mesh = nullptr;
  Topology topology{};
  std::vector<std::size_t> diagonals{};  ///< edges, by their numbers in the topology
  double size = 1;                       ///< of the mesh: the longest side of the box around it
};
[[nodiscard]] Targets targets_of(const ClosedMesh& mesh);

/// The ray that a seed stands for; its numbers are of the precision. Nothing where the surface turns away
/// somewhere around the target: beside an outline a ray may rightly pass.
[[nodiscard]] std::optional<Aim> draw_aim(const Targets& targets, std::uint64_t seed, Precision precision);

}  // namespace rayproof::leaks
