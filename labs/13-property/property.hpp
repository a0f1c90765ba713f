#pragma once
#include <rapidcheck.h>

#include <functional>
#include <glm/glm.hpp>
#include <vector>

using vec3 = glm::dvec3;

/// A function on trial: every t in [t_min, t_max] at which the ray meets the sphere, ascending.
using Intersect = std::function<std::vector<double>(vec3 origin, vec3 direction, double t_min, double t_max,
                                                    vec3 center, double radius)>;

bool property(const Intersect& sphere);
