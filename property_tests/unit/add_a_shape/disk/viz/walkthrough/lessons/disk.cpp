#include "viz/walkthrough/lessons.hpp"

namespace rayproof::viz {

std::vector<Lesson> disk_lessons() {
  return {
      {"disk", "disks", "Ray and disk: the plane first, then a distance",
       "Where the ray meets the disk's plane, it is in the disk if it is no further from the centre than the "
       "radius.",
       R"({"precision": "float32", "ray": {"origin": [1.7, -1.3, 2.3], "direction": [-0.3, 0.6, -0.9]},
           "shape": {"type": "disk", "center": [0.4, 0.3, 0.2], "normal": [0.1, -0.4, 1.2], "radius": 1.3}})",
       "disk/projected"},
  };
}

}  // namespace rayproof::viz
