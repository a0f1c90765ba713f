#pragma once
#include <glm/glm.hpp>
#include <optional>

using vec3 = glm::dvec3;  // in double; dot(a, b), cross(a, b) and + - * / work as on paper

/// t, u and v: the point is origin + t·direction = (1 - u - v)·a + u·b + v·c.
std::optional<vec3> triangle(vec3 origin, vec3 direction, double t_min, double t_max, vec3 a, vec3 b, vec3 c);
