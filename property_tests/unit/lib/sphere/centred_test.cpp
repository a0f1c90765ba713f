#include <gtest/gtest.h>

#include <rayproof/sphere/centred.hpp>

namespace rayproof::sphere {
namespace {

// Why Centred does not take its roots from Viète as its source does: for an origin beside the tangent point,
// b is all rounding, D rounds to 0 and c does not, and c/q is noise of any size.
TEST(Centred, StaysOnTheSphereWhereTheRootsOfItsSourceAreFarOff) {
  const Ray<float> ray{{0.784047723F, -0.0692647696F, 0}, {0.0692647621F, 0.784047723F, 0}};
  const Sphere<float> sphere{{0, 0, 0}, 0.787101269F};
  const glm::vec3 f = ray.origin - sphere.center;
  const glm::vec3 d = ray.direction;
  const float b = -dot(f, d);
  const glm::vec3 l = f + (b / dot(d, d)) * d;
  const float D = sphere.radius * sphere.radius - dot(l, l);
  const float q = b + copysign(sqrt(dot(d, d) * D), b);
  const float c = dot(f, f) - sphere.radius * sphere.radius;
  EXPECT_EQ(D, 0);
  EXPECT_GT(abs(c / q), 10);  // many diameters away

  const Roots<float> roots = Centred::roots(ray, sphere);
  EXPECT_LT(abs(roots.lo), 1e-3F);
  EXPECT_LT(abs(roots.hi), 1e-3F);
}

}  // namespace
}  // namespace rayproof::sphere
