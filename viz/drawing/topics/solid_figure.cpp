#include "viz/drawing/topics/solid_figure.hpp"

#include <algorithm>

namespace rayproof::viz {
namespace {

struct Solid {
  Place corner;
  std::array<Place, 3> edges;
  std::array<Place, 3> normals;  ///< outward, of the faces that hold corner + edges[i]

  /// The corner at the far end of the edges in the set: bit i for edges[i].
  [[nodiscard]] Place at(unsigned set) const {
    Place place = corner;
    for (unsigned i = 0; i < 3; ++i) {
      if ((set >> i & 1U) != 0) place = place + edges[i];
    }
    return place;
  }
};

std::vector<Stroke> strokes_of(const Solid& solid, const Place& toward) {
  std::vector<Stroke> strokes;
  for (unsigned axis = 0; axis < 3; ++axis) {
    for (unsigned set = 0; set < 8; ++set) {
      if ((set >> axis & 1U) != 0) continue;
      // An edge is seen where one of the two faces that meet in it is.
      bool is_seen = false;
      for (unsigned other = 0; other < 3; ++other) {
        if (other == axis) continue;
        const Shadow facing = dot(solid.normals[other], toward);
        is_seen = is_seen || ((set >> other & 1U) != 0 ? facing >= 0 : facing <= 0);
      }
      strokes.push_back({{solid.at(set), solid.at(set | 1U << axis)}, !is_seen});
    }
  }
  return strokes;
}

/// Of the face nearest to a point, by the measure of the edges.
Place normal_of(const Solid& solid, const Place& place) {
  std::size_t best = 0;
  Shadow least = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Shadow whole = dot(solid.normals[i], solid.edges[i]);
    const Shadow part = whole == 0 ? Shadow(0) : Shadow(dot(solid.normals[i], place - solid.corner) / whole);
    const Shadow off = std::min<Shadow>(abs(part), abs(part - 1));
    if (least >= 0 && off >= least) continue;
    least = off;
    best = i;
  }
  return solid.normals[best];
}

}  // namespace

Figure solid_figure(const Place& corner, const std::array<Place, 3>& edges) {
  Solid solid{corner, edges, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Place normal = unit(cross(edges[(i + 1) % 3], edges[(i + 2) % 3]));
    solid.normals[i] = dot(normal, edges[i]) < 0 ? Place(Shadow(-1) * normal) : normal;
  }
  Figure figure;
  for (unsigned set = 0; set < 8; ++set) figure.extent.push_back(solid.at(set));
  figure.normals.assign(solid.normals.begin(), solid.normals.end());
  for (const Stroke& edge : strokes_of(solid, {0, 0, 1})) figure.borders.push_back(edge.points);
  figure.normal_at = [solid](const Place& place) { return normal_of(solid, place); };
  figure.strokes = [solid](const Place& toward) { return strokes_of(solid, toward); };
  return figure;
}

}  // namespace rayproof::viz
