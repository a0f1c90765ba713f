#include "viz/walkthrough/lessons.hpp"

namespace rayproof::viz {

std::vector<Lesson> plane_lessons() {
  return {
      {"plane-implicit", "planes", "Ray and plane, implicit: Ax + By + Cz + D = 0",
       "Put the ray into the equation: what is left of it at the origin, over what one unit of t takes off.",
       R"({"precision": "float32", "ray": {"origin": [-1.2, -2.1, 2.7], "direction": [0.4, 0.7, -0.6]},
           "shape": {"type": "plane", "normal": [0.3, 0.2, 1.1], "d": -0.7}})",
       "plane/implicit"},
      {"plane-point-normal", "planes", "Ray and plane, by a point and the normal",
       "Both the distance to the plane and the ray's progress are measured along the normal; t is their "
       "quotient.",
       R"({"precision": "float32", "ray": {"origin": [1.7, -1.3, 2.3], "direction": [-0.3, 0.6, -0.9]},
           "shape": {"type": "plane", "point": [0.4, 0.3, 0.2], "normal": [0.1, -0.4, 1.2]}})",
       "plane/point_normal"},
      {"plane-parametric", "planes", "Ray and plane, parametric: three equations for t, a and b",
       "A point of the plane is p + a·u + b·v; Cramer's rule finds where that is a point of the ray.",
       R"({"precision": "float32", "ray": {"origin": [2.1, -1.4, 2.6], "direction": [-0.5, 0.5, -0.7]},
           "shape": {"type": "plane", "point": [-0.3, -0.6, 0.1], "u": [1.3, 0.2, 0.1], "v": [-0.2, 1.1, 0.3]}})",
       "plane/parametric"},
  };
}

}  // namespace rayproof::viz
