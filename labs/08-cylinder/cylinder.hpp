#pragma once
#include <glm/glm.hpp>
#include <vector>

using vec3 = glm::dvec3;  // in double; v.x, v.y and v.z are the components

std::vector<double> cylinder(vec3 origin, vec3 direction, double t_min, double t_max, double rx, double ry,
                             double height, bool capped);
