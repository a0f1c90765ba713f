// A program on trial: g++ -std=c++20 -O2 -I property_tests -I lib/include docs/subjects/sphere.cpp -o
// out/sphere
//                     ./rayproof check --subject-command out/sphere --shape sphere
#include "answer_cases.hpp"

using glm::vec2, glm::vec3;

/// Both t at which the line meets the sphere; -1 for none. Put your own code here.
vec2 sphere(vec3 origin, vec3 direction, vec3 center, float radius) {
  const vec3 l = origin - center;
  const float a = dot(direction, direction), b = dot(l, direction);
  const float D = b * b - a * (dot(l, l) - radius * radius);
  if (D < 0) return vec2(-1);
  return vec2(-b - sqrt(D), -b + sqrt(D)) / a;
}

int main() {
  return rayproof::answer_cases(
      sphere);  // more shapes: answer_cases(sphere, triangle, box), a function for each
}
