#pragma once
#include <glm/glm.hpp>
#include <optional>

using vec3 = glm::dvec3;  // in double; dot(a, b), cross(a, b) and + - * / work as on paper

std::optional<double> plane(vec3 origin, vec3 direction, double t_min, double t_max, vec3 normal, double d);
