#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>

#include "subjects/reading.hpp"

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

}  // namespace

/// GLM's glm::intersectRaySphere as a subject: what everybody has at hand.
///
/// It wants a unit direction and gives the nearest distance beyond its own ε, so the ray's direction is made
/// a unit vector and the distance divided by its length; hits outside [t_min, t_max] are dropped. Source:
/// G-Truc Creation, "OpenGL Mathematics (GLM), gtx/intersect", 2020.
Subject glm_sphere() {
  Subject subject;
  subject.topic = sphere::Topic::name;
  subject.name = "glm";
  subject.title = "glm::intersectRaySphere";
  subject.source = {"G-Truc Creation", "OpenGL Mathematics (GLM), gtx/intersect", 2020};
  subject.contract = {
      .standing = Standing::naive,
      .holds = {Claim::ascending, Claim::nan},
      .refuted = {
          {{Claim::robust, "|f|² and the squared projection of a far sphere's centre cancel"},
           {Claim::exact, "a hit at the origin is left out, and so is what its own ε takes for one"}}}};
  subject.answer_by([](const Case& one) {
    return in_precision(one.precision, [&]<class T>(T) -> Answer { return answer_in<T>(one); });
  });
  return subject;
}

}  // namespace rayproof
