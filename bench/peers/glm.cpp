/// \file
/// GLM's gtx/intersect: a sphere, a triangle and a plane. It asks for unit directions.
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>
#include <rayproof/plane/forms.hpp>

#include "bench/peers/peer.hpp"

namespace rayproof::report {

namespace {

/// A ray of unit direction, and the length that its direction had.
template <class T>
struct GlmRay {
  vec3<T> origin, direction;
  T length;
};

template <class T>
struct OnGlmRays {
  [[nodiscard]] static std::optional<GlmRay<T>> prepared(const Ray<T>& ray) {
    const T length = glm::length(ray.direction);
    return GlmRay<T>{ray.origin, ray.direction / length, length};
  }
  [[nodiscard]] static T t_of(const GlmRay<T>& ray, T distance) { return distance / ray.length; }
};

template <class T>
struct GlmSphere : OnGlmRays<T> {
  explicit GlmSphere(const Sphere<T>& shape) : sphere(shape) {}
  [[nodiscard]] T nearest(const GlmRay<T>& ray) const {
    T t{};
    const T squared = sphere.radius * sphere.radius;
    return glm::intersectRaySphere(ray.origin, ray.direction, sphere.center, squared, t) ? t : infinity<T>;
  }
  Sphere<T> sphere;
};

template <class T>
struct GlmTriangle : OnGlmRays<T> {
  explicit GlmTriangle(const Triangle<T>& shape) : triangle(shape) {}
  [[nodiscard]] T nearest(const GlmRay<T>& ray) const {
    const auto& [a, b, c] = triangle;
    glm::vec<2, T> uv{};
    T t{};
    return glm::intersectRayTriangle(ray.origin, ray.direction, a, b, c, uv, t) ? t : infinity<T>;
  }
  Triangle<T> triangle;
};

/// It asks for a unit normal, too.
template <class T>
struct GlmPlane : OnGlmRays<T> {
  explicit GlmPlane(const Plane<T>& shape)
      : point(plane::point_of(shape)), normal(glm::normalize(plane::normal_of(shape))) {}
  [[nodiscard]] T nearest(const GlmRay<T>& ray) const {
    T t{};
    return glm::intersectRayPlane(ray.origin, ray.direction, point, normal, t) ? t : infinity<T>;
  }
  vec3<T> point, normal;
};

}  // namespace

std::vector<PeerRoutine> glm_peers() {
  return {peer_by<GlmSphere<float>, float, Sphere>("sphere", "glm"),
          peer_by<GlmSphere<double>, double, Sphere>("sphere", "glm"),
          peer_by<GlmTriangle<float>, float, Triangle>("triangle", "glm"),
          peer_by<GlmTriangle<double>, double, Triangle>("triangle", "glm"),
          peer_by<GlmPlane<float>, float, Plane>("plane", "glm"),
          peer_by<GlmPlane<double>, double, Plane>("plane", "glm")};
}

}  // namespace rayproof::report
