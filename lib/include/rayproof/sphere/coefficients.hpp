#pragma once
#include <rayproof/method/narration.hpp>
#include <rayproof/sphere.hpp>

namespace rayproof::sphere {

/// A ray put into a sphere's equation: a·t² + 2·half_b·t + c = 0 with a = d·d, half_b = d·f, c = f·f - r² and
/// f = origin - center. In floats each is good to a few ε of its largest term, which is why formulas that
/// begin here lose far spheres.
template <class T>
struct Coefficients {
  T a;
  T half_b;
  T c;
};

template <class T>
[[nodiscard]] constexpr Coefficients<T> coefficients(const Ray<T>& ray, const Sphere<T>& sphere) {
  step<T>("Put the ray into the sphere's equation", "|o + t·d − C|² = r² is a quadratic equation in t.");
  const vec3<T> f = named("f", ray.origin - sphere.center);
  const vec3<T> d = ray.direction;
  return {named("a", dot(d, d)), dot(d, f), named("c", dot(f, f) - sphere.radius * sphere.radius)};
}

}  // namespace rayproof::sphere
