#include "oracle/shapes/solid.hpp"

#include "oracle/geometry/slabs.hpp"

namespace rayproof::oracle {
namespace {

/// The outward normal of the face that holds the point at t; nothing on an edge or corner, where several do.
std::optional<Vector<Ring>> face_normal(const Slabs& slabs, const SlabMeetings& meetings, const Quotient& t) {
  std::optional<Vector<Ring>> normal;
  int faces = 0;
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    const auto& [position, speed, low, high] = meetings[i];
    const Ring place = position * t.denominator() + speed * t.numerator();
    if (sign(place - low * t.denominator()) == 0) {
      normal = Ring(-1.0) * slabs[i].normal;
      ++faces;
    }
    if (sign(place - high * t.denominator()) == 0) {
      normal = slabs[i].normal;
      ++faces;
    }
  }
  return faces == 1 ? normal : std::nullopt;
}

RayAnswer answer_solid(const RayQuestion& question, const Slabs& slabs, Precision precision) {
  const ObjectRay<Ring> ray(question);
  const SlabMeetings met = meetings(ray, slabs);
  const std::optional<Chord> chord = chord_of(met);
  RayAnswer result;
  if (!chord) return result;

  const bool is_touch = chord->is_touch();
  const Quotient* first = nullptr;
  for (const Quotient* end : {&chord->entry, &chord->exit}) {
    if (end == &chord->exit && is_touch) break;
    if (!is_in_interval(*end, question.ray)) continue;
    if (first == nullptr) first = end;
    result.hits.push_back(round_correctly(*end, precision));
  }
  if (first == nullptr) return result;

  result.contact = is_touch ? Contact::tangent : Contact::crossing;
  result.point = exact_point(question.ray, *first, precision);
  if (const auto normal = face_normal(slabs, met, *first))
    result.normal = unit_vector(normal_to_world(ray, *normal), precision);
  return result;
}

}  // namespace

RayAnswer answer(const RayQuestion& question, const Box<double>& box, Precision precision) {
  return answer_solid(question, slabs_of(box), precision);
}

RayAnswer answer(const RayQuestion& question, const Parallelepiped<double>& solid, Precision precision) {
  return answer_solid(question, slabs_of(solid), precision);
}

}  // namespace rayproof::oracle
