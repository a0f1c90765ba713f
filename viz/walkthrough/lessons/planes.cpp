#include "viz/walkthrough/lessons.hpp"

namespace rayproof::viz {

std::vector<Lesson> plane_lessons() {
  return {
      {"plane-implicit", "planes", "Ray and plane, implicit: n·p + d = 0",
       "Put the ray into the equation: what is left of it at the origin, over what one unit of t takes off.",
       R"({"precision": "float32", "ray": {"origin": [-1.2, -2.1, 2.7], "direction": [0.4, 0.7, -0.6]},
           "shape": {"type": "plane", "normal": [0.3, 0.2, 1.1], "d": -0.7}})",
       "plane/implicit"},
      {"plane-point-normal", "planes", "Ray and plane, by a point and the normal",
       "t is the offset to the plane over the ray's progress per unit of t, both measured along n.",
       R"({"precision": "float32", "ray": {"origin": [1.7, -1.3, 2.3], "direction": [-0.3, 0.6, -0.9]},
           "shape": {"type": "plane", "point": [0.4, 0.3, 0.2], "normal": [0.1, -0.4, 1.2]}})",
       "plane/point_normal"},
      {"plane-parametric", "planes", "Ray and plane, parametric: three equations for t, α and β",
       "A point of the plane is p + α·u + β·v; Cramer's rule finds where that is a point of the ray.",
       R"({"precision": "float32", "ray": {"origin": [2.1, -1.4, 2.6], "direction": [-0.5, 0.5, -0.7]},
           "shape": {"type": "plane", "point": [-0.3, -0.6, 0.1], "u": [1.3, 0.2, 0.1], "v": [-0.2, 1.1, 0.3]}})",
       "plane/parametric"},
      {"plane-parallel",
       "planes",
       "A ray parallel to the plane: n·d⃗ = 0",
       "The distance to the plane never changes: no t solves the equation, and the division by 0 must not "
       "look like a hit.",
       R"({"precision": "float32", "ray": {"origin": [-1.5, -1, 1.5], "direction": [1, 0.5, 0]},
           "shape": {"type": "plane", "point": [-0.5, -1.5, 0.5], "normal": [0, 0, 1]}})",
       "plane/point_normal",
       nullptr,
       {{"Compare the distance to the plane with the ray's progress (2",
         "Here the progress is 0, and the distance is not: t is infinite."}}},
      {"plane-inside",
       "planes",
       "A ray in the plane: n·d⃗ = 0, and the distance, too",
       "Every point of the ray is in the plane: there is no first hit to give, and this method calls it a "
       "miss.",
       R"({"precision": "float32", "ray": {"origin": [-1.5, -1, 0.5], "direction": [1, 0.5, 0]},
           "shape": {"type": "plane", "point": [-0.5, -1.5, 0.5], "normal": [0, 0, 1]}})",
       "plane/point_normal",
       nullptr,
       {{"Compare the distance to the plane with the ray's progress (2",
         "Here both are 0, and 0/0 is NaN."}}},
  };
}

}  // namespace rayproof::viz
