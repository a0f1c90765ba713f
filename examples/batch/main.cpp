#include <cstdio>
#include <rayproof/batch.hpp>
#include <rayproof/sphere/centred.hpp>
#include <vector>

using namespace rayproof;

int main() {
  // 1,000 rays from 9,000 away, an array for each coordinate; ray i passes the centre at height i / 500.
  const int count = 1000;
  const std::vector<float> ox(count, 0), oz(count, -9000), dx(count, 0), dy(count, 0), dz(count, 1);
  std::vector<float> oy, t(count);
  for (int i = 0; i < count; ++i) oy.push_back(i / 500.0F);
  const RayBatch<float> rays{{ox, oy, oz}, {dx, dy, dz}};
  nearest_hits<sphere::Centred>(rays, Sphere<float>{{0, 0, 0}, 1}, t);
  int hits = 0;
  for (const float one : t) hits += one < infinity<float>;
  std::printf("%d of %d rays hit\n", hits, count);
}
