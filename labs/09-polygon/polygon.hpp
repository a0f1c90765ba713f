#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

using vec3 = glm::dvec3;  // in double; dot(a, b), cross(a, b) and + - * / work as on paper; v[0] is v.x

std::optional<double> polygon(vec3 origin, vec3 direction, double t_min, double t_max,
                              const std::vector<vec3>& vertices);
