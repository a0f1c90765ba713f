#include "viz/shapes/figure.hpp"

namespace rayproof::viz {
namespace {

/// What of v is at right angles to a unit vector.
Place part_across(const Place& v, const Place& along) { return v - dot(v, along) * along; }

}  // namespace

glm::dvec3 rounded(const Place& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

std::vector<glm::dvec3> rounded(const std::vector<Place>& places) {
  std::vector<glm::dvec3> points;
  points.reserve(places.size());
  for (const Place& p : places) points.push_back(rounded(p));
  return points;
}

Shadow length(const Place& v) { return sqrt(dot(v, v)); }

Place unit(const Place& v) {
  const Shadow size = length(v);
  return size == 0 ? v : Place{v.x / size, v.y / size, v.z / size};
}

Place some_perpendicular(const Place& v) {
  const bool is_along_z = abs(v.x) < Shadow(0.5) && abs(v.y) < Shadow(0.5);
  return unit(cross(v, is_along_z ? Place{1, 0, 0} : Place{0, 0, 1}));
}

World::World(const RayQuestion& question) : x_{1, 0, 0}, y_{0, 1, 0}, z_{0, 0, 1}, translation_{0, 0, 0} {
  if (!question.transform) return;
  const auto column = [&](int i) { return convert<Shadow>(glm::dvec3((*question.transform)[i])); };
  x_ = column(0);
  y_ = column(1);
  z_ = column(2);
  translation_ = column(3);
}

Figure flat_figure(const std::vector<Place>& vertices, const Place& normal,
                   const std::vector<std::string>& names) {
  Figure figure;
  figure.points = vertices;
  figure.normals = {unit(normal)};
  figure.faces.emplace_back();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Place& from = vertices[i];
    const Place& to = vertices[(i + 1) % vertices.size()];
    figure.faces[0].push_back(i);
    figure.borders.push_back({{from, to}, {unit(cross(normal, to - from))}});
    if (i < names.size()) figure.labels.emplace_back(names[i], from);
  }
  return figure;
}

Figure solid_figure(const Place& corner, const std::array<Place, 3>& edges) {
  Figure figure;
  // Bit i of a corner's number is set at the far end of edges[i].
  for (unsigned set = 0; set < 8; ++set) {
    Place place = corner;
    for (unsigned i = 0; i < 3; ++i) {
      if ((set >> i & 1U) != 0) place = place + edges[i];
    }
    figure.points.push_back(place);
  }
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned one = 1U << (axis + 1) % 3;
    const unsigned other = 1U << (axis + 2) % 3;
    const Place& u = edges[(axis + 1) % 3];
    const Place& v = edges[(axis + 2) % 3];
    const Place along = unit(edges[axis]);
    figure.normals.push_back(unit(cross(u, v)));
    for (const unsigned near : {0U, 1U << axis}) {
      figure.faces.push_back({near, near | one, near | one | other, near | other});
    }
    for (const unsigned foot : {0U, one, one | other, other}) {
      const Place into_u = (foot & one) != 0 ? Place(Shadow(-1) * u) : u;
      const Place into_v = (foot & other) != 0 ? Place(Shadow(-1) * v) : v;
      figure.borders.push_back({{figure.points[foot], figure.points[foot | 1U << axis]},
                                {unit(part_across(into_u, along)), unit(part_across(into_v, along))}});
    }
  }
  return figure;
}

}  // namespace rayproof::viz
