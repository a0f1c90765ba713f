#pragma once
#include <glm/glm.hpp>
#include <vector>

using vec3 = glm::dvec3;  // in double; v[0], v[1] and v[2] are the components

std::vector<double> slabs(vec3 origin, vec3 direction, double t_min, double t_max, vec3 min, vec3 max);
