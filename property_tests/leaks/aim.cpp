#include "leaks/aim.hpp"

#include <algorithm>
#include <cmath>

#include "generators/aim.hpp"
#include "generators/scene.hpp"

namespace rayproof::leaks {

namespace {

glm::dvec3 area_of(const Triangle<double>& t) { return cross(t.b - t.a, t.c - t.a); }

bool is_flat(const ClosedMesh& mesh, const std::array<std::size_t, 2>& beside) {
  const glm::dvec3 n = area_of(mesh.triangle(beside[0])), m = area_of(mesh.triangle(beside[1]));
  const glm::dvec3 across = cross(n, m);
  return dot(n, m) > 0 && dot(across, across) <= 0x1p-60 * dot(n, n) * dot(m, m);
}

/// A place on the mesh, the triangles near it, and those that it belongs to.
struct Spot {
  AimedAt target{};
  glm::dvec3 at{};
  std::vector<std::size_t> patch{}, own{};
};

Spot spot_on_edge(const Targets& targets, std::size_t edge, AimedAt target, double share) {
  const auto& [a, b] = targets.topology.edges[edge];
  const std::vector<glm::dvec3>& v = targets.mesh->vertices;
  const auto& beside = targets.topology.beside[edge];
  Spot spot{target, v[a] + share * (v[b] - v[a]), targets.topology.around[a], {beside[0], beside[1]}};
  const std::vector<std::size_t>& more = targets.topology.around[b];
  spot.patch.insert(spot.patch.end(), more.begin(), more.end());
  std::ranges::sort(spot.patch);
  spot.patch.erase(std::unique(spot.patch.begin(), spot.patch.end()), spot.patch.end());
  return spot;
}

Spot draw_spot(const Targets& targets, Random& random) {
  const auto pick = [&](std::size_t count) {
    return static_cast<std::size_t>(random.between(0, static_cast<int>(count) - 1));
  };
  const int kind = random.between(0, targets.diagonals.empty() ? 2 : 3);
  if (kind == 0) {
    const std::size_t vertex = pick(targets.mesh->vertices.size());
    const auto& around = targets.topology.around[vertex];
    return {AimedAt::vertex, targets.mesh->vertices[vertex], around, around};
  }
  const std::size_t edge =
      kind == 3 ? targets.diagonals[pick(targets.diagonals.size())] : pick(targets.topology.edges.size());
  const double share = kind == 1 ? 0.5 : random.uniform(0.1, 0.9);
  return spot_on_edge(targets, edge, static_cast<AimedAt>(kind), share);
}

/// A direction of few bits, so that the ray may meet its target exactly, or any.
glm::dvec3 draw_direction(Random& random) {
  if (!random.one_in(4)) return draw::unit_vector(random);
  const auto few = [&] { return std::ldexp(random.between(-4, 4), -3); };
  const glm::dvec3 d{few(), few(), few()};
  return d == glm::dvec3(0) ? glm::dvec3(0, 0, 1) : d;
}

/// Whether every triangle is clearly seen from one and the same side.
bool is_seen_from_one_side(const ClosedMesh& mesh, const std::vector<std::size_t>& patch,
                           const glm::dvec3& d) {
  bool has_front = false, has_back = false;
  for (const std::size_t number : patch) {
    const glm::dvec3 n = area_of(mesh.triangle(number));
    const double slope = dot(n, d), least = 1e-3 * std::sqrt(dot(n, n) * dot(d, d));
    has_front |= slope < least;
    has_back |= slope > -least;
  }
  return has_front != has_back;
}

}  // namespace

Targets targets_of(const ClosedMesh& mesh) {
  Targets targets{.mesh = &mesh, .topology = topology_of(mesh)};
  for (std::size_t edge = 0; edge < targets.topology.edges.size(); ++edge)
    if (is_flat(mesh, targets.topology.beside[edge])) targets.diagonals.push_back(edge);
  glm::dvec3 low = mesh.vertices.front(), high = low;
  for (const glm::dvec3& v : mesh.vertices) {
    low = min(low, v);
    high = max(high, v);
  }
  targets.size = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  return targets;
}

std::optional<Aim> draw_aim(const Targets& targets, std::uint64_t seed, Precision precision) {
  Random random(seed);
  Spot spot = draw_spot(targets, random);
  const glm::dvec3 towards = draw_direction(random);
  const double distance = targets.size * std::exp2(random.uniform(-4, 3));
  const double length = random.one_in(2) ? 1 : std::exp2(random.uniform(-4, 4));
  const glm::dvec3 origin = rayproof::rounded(precision, spot.at - distance * towards);
  const glm::dvec3 direction = rayproof::rounded(precision, length * (spot.at - origin));
  if (direction == glm::dvec3(0)) return std::nullopt;
  // Where the surface turns away at an end of the edge, there is still the middle, far from both ends.
  if (!is_seen_from_one_side(*targets.mesh, spot.patch, direction)) spot.patch = spot.own;
  if (!is_seen_from_one_side(*targets.mesh, spot.patch, direction)) return std::nullopt;
  const bool from_inside = dot(area_of(targets.mesh->triangle(spot.patch.front())), direction) > 0;
  return Aim{spot.target, from_inside, Ray<double>{origin, direction}, std::move(spot.patch)};
}

}  // namespace rayproof::leaks
