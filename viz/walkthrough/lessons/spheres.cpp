#include "viz/walkthrough/lessons.hpp"

namespace rayproof::viz {

std::vector<Lesson> sphere_lessons() {
  return {
      {"sphere",
       "spheres",
       "Ray and sphere: the discriminant is geometry",
       "The discriminant is r² less the squared distance of the ray from the centre: half a chord, squared.",
       R"({"precision": "float32", "ray": {"origin": [-3.7, -0.9, 0.4], "direction": [1.3, 0.5, 0.1]},
           "shape": {"type": "sphere", "center": [0.2, 0.1, 0.3], "radius": 1.4}})",
       "sphere/centred",
       nullptr,
       {{"Compare its distance", "r is the hypotenuse, |l| and half the chord are the legs."}}},
      {"sphere-textbook", "spheres", "Ray and sphere by the quadratic formula",
       "Three coefficients, a discriminant, two roots: fine near by, and with no picture of why.",
       R"({"precision": "float32", "ray": {"origin": [-3.7, -0.9, 0.4], "direction": [1.3, 0.5, 0.1]},
           "shape": {"type": "sphere", "center": [0.2, 0.1, 0.3], "radius": 1.4}})",
       "sphere/textbook"},
      {"sphere-half-b",
       "spheres",
       "Ray and sphere with half of b",
       "With b = d·f in place of 2d·f every factor 2 cancels; for |d| = 1 so does a.",
       R"({"precision": "float32", "ray": {"origin": [-3.5, -0.5, 0.25], "direction": [1, 0, 0]},
           "shape": {"type": "sphere", "center": [0.25, 0.25, 0.25], "radius": 1.25}})",
       "sphere/half_b",
       nullptr,
       {{"Apply the halved quadratic formula (2",
         "Here |d| = 1, so a = 1 and the division changes nothing."}}},
      {"far-sphere",
       "numbers",
       "Why a far sphere breaks",
       "A ray passes a fifth of the radius from the centre, and the textbook's formula calls it a miss: "
       "rounded, b² and 4ac differ by two ulps, with the wrong sign.",
       R"({"precision": "float32", "ray": {"origin": [0, 0.2, -4499.9], "direction": [0, 0, 9]},
           "shape": {"type": "sphere", "center": [0, 0, 0], "radius": 1}})",
       "sphere/textbook",
       nullptr,
       {{"Form the discriminant",
         "Here b² is rounded to 6560707584 and 4ac to 6560708608: two ulps of 512 apart, and in the wrong "
         "order."}}},
      {"far-sphere-centred", "numbers", "The same far sphere, from the ray point nearest its centre",
       "|f|² is never formed: only r² − |l|², two numbers of the sphere's own size.",
       R"({"precision": "float32", "ray": {"origin": [0, 0.2, -4499.9], "direction": [0, 0, 9]},
           "shape": {"type": "sphere", "center": [0, 0, 0], "radius": 1}})",
       "sphere/centred"},
  };
}

}  // namespace rayproof::viz
