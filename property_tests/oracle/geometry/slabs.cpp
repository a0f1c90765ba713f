#include "oracle/geometry/slabs.hpp"

namespace rayproof::oracle {

SlabMeetings meetings(const ObjectRay<Ring>& ray, const Box<double>& box) {
  const auto slab = [&](int axis) {
    glm::dvec3 normal(0);
    normal[axis] = 1;
    return SlabMeeting(ray, Vector<Ring>::from(normal), Ring(box.min[axis]), Ring(box.max[axis]));
  };
  return {slab(0), slab(1), slab(2)};
}

SlabMeetings meetings(const ObjectRay<Ring>& ray, const Parallelepiped<double>& solid) {
  const auto corner = Vector<Ring>::from(solid.corner);
  const auto edge = [&](std::size_t i) { return Vector<Ring>::from(solid.edges[i]); };
  const std::array edges{edge(0), edge(1), edge(2)};
  const auto slab = [&](std::size_t i) {
    Vector<Ring> normal = cross(edges[(i + 1) % 3], edges[(i + 2) % 3]);
    if (sign(dot(normal, edges[i])) < 0) normal = -normal;
    const Ring low = dot(normal, corner);
    return SlabMeeting(ray, normal, low, low + dot(normal, edges[i]));
  };
  return {slab(0), slab(1), slab(2)};
}

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
