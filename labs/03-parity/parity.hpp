#pragma once
#include <glm/glm.hpp>
#include <vector>

using vec2 = glm::dvec2;  // in double, with members x and y

bool parity(vec2 point, const std::vector<vec2>& vertices);
