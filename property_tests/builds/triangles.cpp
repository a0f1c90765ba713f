/// \file
/// Watertight triangles as this very build computes them, as subjects of `rayproof leak --subject-command`:
///
///     rayproof-build-triangles published|woop|plucker|rounded

#include <cmath>
#include <rayproof/triangle/plucker.hpp>
#include <rayproof/triangle/rounded.hpp>
#include <rayproof/triangle/woop.hpp>
#include <string_view>

#include "answer_cases.hpp"

namespace rayproof {
namespace {

/// The code of S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle Intersection", 2013, without culling.
/// Its edge functions are plain products: where a compiler fuses one of the two products with the difference,
/// the two triangles at an edge no longer get opposite values.
std::optional<float> published(const Ray<float>& ray, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
  const glm::vec3 size = glm::abs(ray.direction);
  const int kz = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int kx = (kz + 1) % 3, ky = (kx + 1) % 3;
  if (ray.direction[kz] < 0) std::swap(kx, ky);
  const float Sx = ray.direction[kx] / ray.direction[kz];
  const float Sy = ray.direction[ky] / ray.direction[kz];
  const float Sz = 1.0F / ray.direction[kz];
  const glm::vec3 A = a - ray.origin, B = b - ray.origin, C = c - ray.origin;
  const float Ax = A[kx] - Sx * A[kz], Ay = A[ky] - Sy * A[kz];
  const float Bx = B[kx] - Sx * B[kz], By = B[ky] - Sy * B[kz];
  const float Cx = C[kx] - Sx * C[kz], Cy = C[ky] - Sy * C[kz];
  float U = Cx * By - Cy * Bx;
  float V = Ax * Cy - Ay * Cx;
  float W = Bx * Ay - By * Ax;
  if (U == 0.0F || V == 0.0F || W == 0.0F) {
    U = static_cast<float>(double(Cx) * double(By) - double(Cy) * double(Bx));
    V = static_cast<float>(double(Ax) * double(Cy) - double(Ay) * double(Cx));
    W = static_cast<float>(double(Bx) * double(Ay) - double(By) * double(Ax));
  }
  if ((U < 0.0F || V < 0.0F || W < 0.0F) && (U > 0.0F || V > 0.0F || W > 0.0F)) return {};
  const float det = U + V + W;
  if (det == 0.0F) return {};
  const float T = U * (Sz * A[kz]) + V * (Sz * B[kz]) + W * (Sz * C[kz]);
  const float t = T / det;
  return ray.t_min <= t && t <= ray.t_max ? std::optional(t) : std::nullopt;
}

/// A method of the library's.
template <class Method, class T>
std::optional<T> own(const Ray<T>& ray, vec3<T> a, vec3<T> b, vec3<T> c) {
  const FlatHit<T> hit = Method::roots(ray, Triangle<T>{a, b, c});
  return in_interval(ray, hit.lo) ? std::optional(hit.lo) : std::nullopt;
}

template <class Method>
int answer_with() {
  return answer_cases(own<Method, float>, own<Method, double>);
}

}  // namespace
}  // namespace rayproof

int main(int count, char** arguments) {
  using namespace rayproof;
  const std::string_view which = count > 1 ? arguments[1] : "";
  if (which == "published") return answer_cases(published);
  if (which == "woop") return answer_with<triangle::Woop>();
  if (which == "plucker") return answer_with<triangle::Plucker>();
  if (which == "rounded") return answer_with<triangle::Rounded>();
  std::cerr << "rayproof-build-triangles: published, woop, plucker or rounded\n";
  return 2;
}
