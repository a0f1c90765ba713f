#include <rayproof/sphere/methods.hpp>
#include <rayproof/transform.hpp>

#include "viz/record.hpp"
#include "viz/topics.hpp"
#include "viz/topics/sphere_picture.hpp"

namespace rayproof::viz {
namespace {

/// The ray as the sphere's own space sees it, narrated like a step of the method.
template <class R>
Ray<R> in_object_space(const Ray<R>& ray, const glm::dmat4& transform) {
  const auto column = [&](const char* name, int i) {
    return named(name, convert<R>(glm::dvec3(transform[i])));
  };
  const vec3<R> a = column("A₁", 0);
  const vec3<R> b = column("A₂", 1);
  const vec3<R> c = column("A₃", 2);
  const vec3<R> translation = column("T", 3);
  step<R>("Take the ray into the sphere's own space");
  Ray<R> inside = to_object(object_space<R>(a, b, c, translation), ray);
  inside.origin = named("o′", inside.origin);
  inside.direction = named("d", inside.direction);
  return inside;
}

std::optional<Walkthrough> walk(const Case& one, const std::string& method) {
  const auto& question = std::get<RayQuestion>(one.question);
  return walk_topic<sphere::Topic>(method, one.precision, [&]<class R>(std::type_identity<R>) {
    Ray<R> ray = convert<R>(question.ray);
    ray.origin = named("o", ray.origin);
    ray.direction = named(question.transform ? "v" : "d", ray.direction);
    auto shape = convert<R>(std::get<Sphere<double>>(question.shape));
    shape.center = named("C", shape.center);
    shape.radius = named("r", shape.radius);
    if (question.transform) ray = in_object_space(ray, *question.transform);
    return sphere::Topic::Problem<R>{ray, shape};
  });
}

}  // namespace

TopicView sphere_view();
TopicView sphere_view() { return {sphere::Topic::name, sphere_picture, walk}; }

}  // namespace rayproof::viz
