#include "viz/walkthrough/lessons.hpp"

namespace rayproof::viz {
namespace {

constexpr const char* one_triangle =
    R"({"precision": "float32", "ray": {"origin": [0.7, -1.9, 2.4], "direction": [-0.2, 0.9, -0.8]},
        "shape": {"type": "triangle", "a": [-1.1, -0.4, 0.3], "b": [1.6, -0.2, 0.1], "c": [0.2, 1.3, 0.6]}})";

}  // namespace

std::vector<Lesson> triangle_lessons() {
  return {
      {"triangle-1", "triangles", "Ray and triangle I: a parametric plane with three conditions",
       "Cramer's rule gives t and the two parameters; inside needs α ≥ 0, β ≥ 0, and also α + β ≤ 1, which "
       "the lecture forgets.",
       one_triangle, "triangle/cramer"},
      {"triangle-2", "triangles", "Ray and triangle II: the plane, then the shadow along the largest axis",
       "Where the normal is largest the shadow keeps the most of the area; in it the coordinates are plane "
       "geometry.",
       one_triangle, "triangle/plane_projection"},
      {"moller-trumbore", "triangles", "Ray and triangle by Möller and Trumbore",
       "Two cross products give t, u and v, and the normal is never formed.", one_triangle,
       "triangle/moller_trumbore"},
      {"woop", "triangles", "Ray and triangle by Woop: the scene sheared until the ray is the z axis",
       "Three signs say on which side the ray passes each edge; a shared edge has one sign for both "
       "triangles, so "
       "nothing leaks.",
       one_triangle, "triangle/woop"},
  };
}

}  // namespace rayproof::viz
