#include "oracle/shapes/plane.hpp"

#include "oracle/geometry/flat.hpp"

namespace rayproof::oracle {
namespace {

RayAnswer answer_plane(const RayQuestion& question, const FlatEquation& plane, Precision precision) {
  const ObjectRay<Ring> ray(question);
  const FlatMeeting meeting(ray, plane);
  RayAnswer miss;
  if (meeting.is_parallel()) {
    miss.contact = meeting.parallel_contact();
    return miss;
  }
  const Quotient t = meeting.t();
  if (!is_in_interval(t, question.ray)) return miss;
  return flat_answer(question, ray, plane.normal, t, Contact::crossing, precision);
}

FlatEquation through(const glm::dvec3& point, const Vector<Ring>& normal) {
  return {normal, dot(normal, Vector<Ring>::from(point))};
}

}  // namespace

RayAnswer answer(const RayQuestion& question, const ImplicitPlane& plane, Precision precision) {
  return answer_plane(question, {Vector<Ring>::from(plane.normal), Ring(-plane.d)}, precision);
}

RayAnswer answer(const RayQuestion& question, const PointNormalPlane& plane, Precision precision) {
  return answer_plane(question, through(plane.point, Vector<Ring>::from(plane.normal)), precision);
}

RayAnswer answer(const RayQuestion& question, const ParametricPlane& plane, Precision precision) {
  const Vector<Ring> normal = cross(Vector<Ring>::from(plane.u), Vector<Ring>::from(plane.v));
  return answer_plane(question, through(plane.point, normal), precision);
}

}  // namespace rayproof::oracle
