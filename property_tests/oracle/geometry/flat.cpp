#include "oracle/geometry/flat.hpp"

namespace rayproof::oracle {

RayAnswer flat_answer(const RayQuestion& question, const ObjectRay<Ring>& ray, const Vector<Ring>& normal,
                      const Quotient& t, Contact contact, Precision precision) {
  RayAnswer answer;
  answer.contact = contact;
  answer.hits.push_back(round_correctly(t, precision));
  answer.point = exact_point(question.ray, t, precision);
  answer.normal = unit_vector(normal_to_world(ray, normal), precision);
  return answer;
}

}  // namespace rayproof::oracle
