#define GLM_ENABLE_EXPERIMENTAL
#include "subjects/glm_sphere.hpp"

#include <glm/gtx/intersect.hpp>

#include "subjects/solve_topics.hpp"

namespace rayproof {
namespace {

template <class T>
RayAnswer answer_in(const Case& one) {
  RayAnswer result;
  result.nearest_only = true;
  const auto [ray, sphere] = Reading<sphere::Topic>::problem<T>(one);
  const T length = glm::length(ray.direction);
  T distance{};
  if (!glm::intersectRaySphere(ray.origin, ray.direction / length, sphere.center,
                               sphere.radius * sphere.radius, distance)) {
    return result;
  }
  const T t = distance / length;
  if (!in_interval(ray, t)) return result;
  result.contact = Contact::crossing;
  result.hits.push_back(static_cast<double>(t));
  return result;
}

Answer answer_case(const Case& one) {
  return one.precision == Precision::float32 ? answer_in<float>(one) : answer_in<double>(one);
}

}  // namespace

Subject glm_sphere() {
  Subject subject;
  subject.topic = sphere::Topic::name;
  subject.name = "glm";
  subject.title = "glm::intersectRaySphere";
  subject.source = {"G-Truc Creation", "OpenGL Mathematics (GLM), gtx/intersect", 2020};
  subject.contract = {
      .standing = Standing::naive,
      .holds = {Claim::ascending, Claim::nan},
      .refuted = {{{Claim::robust, "|f|² and the squared projection of a far sphere's centre cancel"}}}};
  subject.answer = answer_case;
  return subject;
}

}  // namespace rayproof
