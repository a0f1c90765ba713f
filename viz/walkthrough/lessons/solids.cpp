#include "viz/walkthrough/lessons.hpp"

namespace rayproof::viz {

std::vector<Lesson> solid_lessons() {
  return {
      {"cylinder", "cylinders", "Ray and open elliptic cylinder",
       "In the plane scaled by the semi-axes the side is the unit circle; those of its roots that lie "
       "between both "
       "ends are hits.",
       R"({"precision": "float32", "ray": {"origin": [-3.4, -0.9, 0.6], "direction": [1.4, 0.4, 0.2]},
           "shape": {"type": "cylinder", "rx": 1.6, "ry": 0.9, "height": 2.2, "capped": false}})",
       "cylinder/centred"},
      {"cylinder-capped", "cylinders", "Ray and capped elliptic cylinder",
       "What is inside the side and between both ends is inside the solid: the last entry and the first "
       "exit.",
       R"({"precision": "float32", "ray": {"origin": [-2.6, -0.8, 3.4], "direction": [0.9, 0.3, -0.8]},
           "shape": {"type": "cylinder", "rx": 1.6, "ry": 0.9, "height": 2.2, "capped": true}})",
       "cylinder/centred"},
      {"slabs", "boxes", "Ray and box: three slabs",
       "Between the planes of each axis the ray spends an interval of t; where all three overlap it is in "
       "the box.",
       R"({"precision": "float32", "ray": {"origin": [-2.4, -1.7, 1.9], "direction": [0.9, 0.7, -0.4]},
           "shape": {"type": "box", "min": [-0.8, -0.6, 0.1], "max": [1.3, 0.9, 1.2]}})",
       "box/slabs"},
      {"parallelepiped", "boxes", "Ray and parallelepiped: three pairs of parallel planes",
       "An oblique box has slabs, too: their normals are the cross products of its edges.",
       R"({"precision": "float32", "ray": {"origin": [-2.7, -1.1, 1.8], "direction": [1.1, 0.5, -0.3]},
           "shape": {"type": "parallelepiped", "corner": [-0.7, -0.5, 0.2],
                     "edges": [[1.7, 0.2, 0.1], [0.5, 1.3, 0.2], [-0.2, 0.3, 1.2]]}})",
       "parallelepiped/face_planes"},
      {"conservative",
       "numbers",
       "Conservative is not exact",
       "The ray passes beside an edge, and the computed exit comes before the computed entry: a miss. Two "
       "ulps "
       "of padding alone make a hit of it.",
       R"({"precision": "float32", "ray": {"origin": [-4, -1.4, 0.5], "direction": [4, 3.70000052, 0.1]},
           "shape": {"type": "box", "min": [0, 0, 0], "max": [2.2, 2.3, 1.5]}})",
       "box/padded",
       nullptr,
       {{"Keep the last entry", "Here the exit comes first, computed as well as exactly."}}},
  };
}

}  // namespace rayproof::viz
