#include "oracle/geometry/slabs.hpp"

namespace rayproof::oracle {

Slabs slabs_of(const Box<double>& box) {
  const auto axis = [](double x, double y, double z) { return Vector<Ring>{Ring(x), Ring(y), Ring(z)}; };
  return {Slab{axis(1, 0, 0), Ring(box.min.x), Ring(box.max.x)},
          Slab{axis(0, 1, 0), Ring(box.min.y), Ring(box.max.y)},
          Slab{axis(0, 0, 1), Ring(box.min.z), Ring(box.max.z)}};
}

Slabs slabs_of(const Parallelepiped<double>& solid) {
  const auto corner = Vector<Ring>::from(solid.corner);
  const std::array<Vector<Ring>, 3> edges{Vector<Ring>::from(solid.edges[0]),
                                          Vector<Ring>::from(solid.edges[1]),
                                          Vector<Ring>::from(solid.edges[2])};
  const auto slab = [&](std::size_t i) {
    Vector<Ring> normal = cross(edges[(i + 1) % 3], edges[(i + 2) % 3]);
    if (sign(dot(normal, edges[i])) < 0) normal = -normal;
    const Ring low = dot(normal, corner);
    return Slab{normal, low, low + dot(normal, edges[i])};
  };
  return {slab(0), slab(1), slab(2)};
}

SlabMeeting::SlabMeeting(const ObjectRay<Ring>& ray, const Slab& slab)
    : position(dot(slab.normal, ray.origin)),
      speed(dot(slab.normal, ray.direction)),
      low(ray.scale * slab.low),
      high(ray.scale * slab.high) {}

std::optional<Chord> chord_of(const SlabMeetings& slabs) {
  std::optional<Chord> chord;
  for (const SlabMeeting& slab : slabs) {
    if (slab.is_parallel()) {
      if (!slab.is_inside()) return std::nullopt;
      continue;
    }
    const Quotient entry = slab.entry();
    const Quotient exit = slab.exit();
    if (!chord) {
      chord = Chord{entry, exit};
      continue;
    }
    if (entry.compare(chord->entry) > 0) chord->entry = entry;
    if (exit.compare(chord->exit) < 0) chord->exit = exit;
  }
  // The three normals are independent, so that no line is parallel to all.
  if (chord->entry.compare(chord->exit) > 0) return std::nullopt;
  return chord;
}

}  // namespace rayproof::oracle
