// What a user of the installed library writes: hits a unit sphere from five units away.
#include <cstdio>
#include <rayproof/sphere/centred.hpp>

int main() {
  const rayproof::Ray<float> ray{{0, 0, -5}, {0, 0, 1}};
  const rayproof::Sphere<float> sphere{{0, 0, 0}, 1};
  const float t = rayproof::nearest(ray, rayproof::sphere::Centred::roots(ray, sphere));
  std::printf("hit at t = %g\n", static_cast<double>(t));
  return t == 4.0F ? 0 : 1;
}
