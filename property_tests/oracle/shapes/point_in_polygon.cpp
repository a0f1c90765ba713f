/// \file
/// The oracle for point in polygon.

#include <ranges>
#include <utility>

#include "oracle/geometry/locate.hpp"
#include "oracle/geometry/sizes.hpp"
#include "oracle/judge/judging.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

/// A point of the plane in another arithmetic.
template <class R>
PlanePoint<R> in(const Vec2<double>& v) {
  return {R(v.x), R(v.y)};
}

template <class R>
Contact contact_of(const PointAndPolygon<double>& question) {
  return locate(in<R>(question.point), R(1.0), question.vertices, in<R>);
}

/// The distance of the point from the nearest side in units of |point| + P.
Scaled margin_of(const PointAndPolygon<double>& question) {
  const auto length = [](const Vec2<double>& v) { return norm(glm::dvec3(v.x, v.y, 0)); };
  Scaled farthest, nearest = endless();
  for (const auto& vertex : question.vertices) farthest = std::max(farthest, length(vertex));
  const Scaled reach = length(question.point) + farthest;
  const PlanePoint<Ring> point = in<Ring>(question.point);
  PlanePoint<Ring> from = in<Ring>(question.vertices.back());
  for (const auto& vertex : question.vertices) {
    PlanePoint<Ring> to = in<Ring>(vertex);
    reduce(nearest, ratio(distance_to_side(point, Ring(1.0), from, to), reach));
    from = std::move(to);
  }
  return nearest;
}

}  // namespace

Position answer(const PointAndPolygon<double>& question, Precision) {
  // Estimates by themselves cost half of what a ring does, whose numbers may be either.
  const Contact contact = Filtering::is_on ? contact_of<Estimate>(question) : contact_of<Ring>(question);
  if (contact == Contact::crossing) return Position::inside;
  return contact == Contact::none ? Position::outside : Position::boundary;
}

Judgement judge(const PointAndPolygon<double>& question, Precision precision, Position claimed) {
  const Position exact = answer(question, precision);
  Judgement judgement;
  Magnitudes lengths;
  lengths.note(question.point);
  lengths.note(question.vertices);
  lengths.put(judgement);
  judgement.hit = exact != Position::outside;
  judgement.wrong = claimed != exact;
  if (judgement.wrong) {
    judgement.ulp = std::nan("");
    judgement.margin = exact == Position::boundary ? 0 : in_units(margin_of(question), precision);
  }
  return judgement;
}

}  // namespace rayproof::oracle
