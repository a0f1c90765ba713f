#pragma once
#include <glm/glm.hpp>
#include <vector>

using vec3 = glm::dvec3;  // in double; dot(a, b), length(a) and + - * / work as on paper

std::vector<double> far_sphere(vec3 origin, vec3 direction, double t_min, double t_max, vec3 center,
                               double radius);
