#include "viz/walkthrough/lessons.hpp"

namespace rayproof::viz {

std::vector<Lesson> sphere_lessons() {
  return {
      {"sphere", "spheres", "Ray and sphere: the discriminant is geometry",
       "The discriminant is r² less the squared distance of the ray from the centre: half a chord, squared.",
       R"({"precision": "float32", "ray": {"origin": [-3.7, -0.9, 0.4], "direction": [1.3, 0.5, 0.1]},
           "shape": {"type": "sphere", "center": [0.2, 0.1, 0.3], "radius": 1.4}})",
       "sphere/centred"},
      {"sphere-textbook", "spheres", "Ray and sphere by the quadratic formula",
       "Three coefficients, a discriminant, two roots: fine near by, and with no picture of why.",
       R"({"precision": "float32", "ray": {"origin": [-3.7, -0.9, 0.4], "direction": [1.3, 0.5, 0.1]},
           "shape": {"type": "sphere", "center": [0.2, 0.1, 0.3], "radius": 1.4}})",
       "sphere/textbook"},
      {"far-sphere", "numbers", "Why a far sphere breaks",
       "A ray passes a fifth of the radius from the centre, and the textbook's formula calls it a miss: b² "
       "and 4ac "
       "agree in all the digits that are kept.",
       R"({"precision": "float32", "ray": {"origin": [0, 0.2, -4499.9], "direction": [0, 0, 9]},
           "shape": {"type": "sphere", "center": [0, 0, 0], "radius": 1}})",
       "sphere/textbook"},
      {"far-sphere-centred", "numbers", "The same far sphere, from the ray point nearest its centre",
       "Nothing as large as |f|² is ever squared and subtracted, so the digits live.",
       R"({"precision": "float32", "ray": {"origin": [0, 0.2, -4499.9], "direction": [0, 0, 9]},
           "shape": {"type": "sphere", "center": [0, 0, 0], "radius": 1}})",
       "sphere/centred"},
  };
}

}  // namespace rayproof::viz
