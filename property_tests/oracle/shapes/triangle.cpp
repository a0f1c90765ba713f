#include "oracle/shapes/triangle.hpp"

#include "oracle/geometry/triangle_volumes.hpp"

namespace rayproof::oracle {

RayAnswer answer(const RayQuestion& question, const Triangle<double>& triangle, Precision precision) {
  const FlatEquation plane = plane_of(triangle);
  RayAnswer miss;
  if (is_zero(plane.normal)) {
    miss.contact = Contact::degenerate;
    return miss;
  }
  const ObjectRay<Ring> ray(question);
  const FlatMeeting meeting(ray, plane);
  if (meeting.is_parallel()) {
    miss.contact = meeting.parallel_contact();
    return miss;
  }
  const TriangleVolumes volumes(ray, triangle);
  if (!volumes.is_inside()) return miss;
  const Quotient t = meeting.t();
  if (!is_in_interval(t, question.ray)) return miss;

  const int on_sides = volumes.zeros();
  const Contact contact = on_sides == 2 ? Contact::vertex : on_sides == 1 ? Contact::edge : Contact::crossing;
  RayAnswer result = flat_answer(question, ray, plane.normal, t, contact, precision);
  const Ring sum = volumes.sum();
  result.barycentric = glm::dvec3(round_correctly(Quotient(volumes.a, sum), precision),
                                  round_correctly(Quotient(volumes.b, sum), precision),
                                  round_correctly(Quotient(volumes.c, sum), precision));
  return result;
}

}  // namespace rayproof::oracle
