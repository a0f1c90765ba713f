#include "oracle/shapes/plane.hpp"

#include "oracle/judge/flat_judge.hpp"

namespace rayproof::oracle {
namespace {

FlatEquation through(const glm::dvec3& point, const Vector<Ring>& normal) {
  return {normal, dot(normal, Vector<Ring>::from(point))};
}
FlatEquation equation_of(const ImplicitPlane& plane) {
  return {Vector<Ring>::from(plane.normal), Ring(-plane.d)};
}
FlatEquation equation_of(const PointNormalPlane& plane) {
  return through(plane.point, Vector<Ring>::from(plane.normal));
}
FlatEquation equation_of(const ParametricPlane& plane) {
  return through(plane.point, cross(Vector<Ring>::from(plane.u), Vector<Ring>::from(plane.v)));
}

template <class Plane>
RayAnswer answer_plane(const RayQuestion& question, const Plane& plane, Precision precision) {
  const ObjectRay<Ring> ray(question);
  const FlatEquation equation = equation_of(plane);
  const FlatMeeting meeting(ray, equation);
  RayAnswer miss;
  if (meeting.is_parallel()) {
    miss.contact = meeting.parallel_contact();
    return miss;
  }
  const Quotient t = meeting.t();
  if (!is_in_interval(t, question.ray)) return miss;
  return flat_answer(question, ray, equation.normal, t, Contact::crossing, precision);
}

}  // namespace

RayAnswer answer(const RayQuestion& question, const ImplicitPlane& plane, Precision precision) {
  return answer_plane(question, plane, precision);
}
RayAnswer answer(const RayQuestion& question, const PointNormalPlane& plane, Precision precision) {
  return answer_plane(question, plane, precision);
}
RayAnswer answer(const RayQuestion& question, const ParametricPlane& plane, Precision precision) {
  return answer_plane(question, plane, precision);
}

Judgement judge(const RayQuestion& question, const ImplicitPlane& plane, Precision precision,
                const RayAnswer& claimed) {
  const Scaled size = norm(plane.normal);
  const FlatFigure figure(question, equation_of(plane), size, abs(Scaled(plane.d)) / size);
  return judge_hits(question, figure, precision, claimed);
}

Judgement judge(const RayQuestion& question, const PointNormalPlane& plane, Precision precision,
                const RayAnswer& claimed) {
  const FlatFigure figure(question, equation_of(plane), norm(plane.normal), norm(plane.point));
  return judge_hits(question, figure, precision, claimed);
}

Judgement judge(const RayQuestion& question, const ParametricPlane& plane, Precision precision,
                const RayAnswer& claimed) {
  const FlatFigure figure(question, equation_of(plane), norm(plane.u) * norm(plane.v), norm(plane.point));
  return judge_hits(question, figure, precision, claimed);
}

}  // namespace rayproof::oracle
