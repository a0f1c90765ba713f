#pragma once
#include <glm/glm.hpp>
#include <optional>

using vec3 = glm::dvec3;  // in double; + - * / work as on paper; v[0] is v.x

std::optional<double> watertight(vec3 origin, vec3 direction, double t_min, double t_max, vec3 a, vec3 b,
                                 vec3 c);
