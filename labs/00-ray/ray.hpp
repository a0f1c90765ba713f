#pragma once
#include <glm/glm.hpp>

using vec3 = glm::dvec3;  // in double; + - * / work as on paper; dot(a, b), length(a)

double ray(vec3 origin, vec3 direction, double t_min, double t_max, vec3 point);
