#pragma once
#include <glm/glm.hpp>
#include <vector>

using vec3 = glm::dvec3;  // in double; dot(a, b), length(a) and + - * / work as on paper
using vec4 = glm::dvec4;
using mat3 = glm::dmat3;
using mat4 = glm::dmat4;  // inverse(m), transpose(m), m * v; mat3(m) is its upper left part

struct HitWithNormal {
  double t;
  vec3 normal;  // in the world, of length 1, outward
};

std::vector<HitWithNormal> transform(vec3 origin, vec3 direction, double t_min, double t_max, vec3 center,
                                     double radius, const mat4& m);
