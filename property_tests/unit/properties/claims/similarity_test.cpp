#include "properties/claims/similarity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "case/reader.hpp"

namespace rayproof {
namespace {

/// In float32, four maps of six take so distant an origin beyond the greatest number. The length of the
/// direction chooses the map.
TEST(MovedCase, IsRefusedWhereTheMapTakesTheRayBeyondTheGreatestNumber) {
  Case one = read_case(
      R"({"precision": "float32", "ray": {"origin": [3e38,3e38,3e38], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})");
  int moved = 0, refused = 0;
  for (int length = 1; length <= 64; ++length) {
    std::get<RayQuestion>(one.question).ray.direction.z = length;
    const std::optional<Case> other = moved_case(one);
    if (!other) {
      ++refused;
      continue;
    }
    ++moved;
    const glm::dvec3 origin = std::get<RayQuestion>(other->question).ray.origin;
    EXPECT_TRUE(std::isfinite(origin.x) && std::isfinite(origin.y) && std::isfinite(origin.z)) << length;
  }
  EXPECT_GT(moved, 0);
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace rayproof
