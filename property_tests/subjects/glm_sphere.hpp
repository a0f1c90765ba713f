#pragma once
#include "subjects/subject.hpp"

namespace rayproof {

/// GLM's glm::intersectRaySphere as a subject: what everybody has at hand.
///
/// It wants a unit direction and gives the nearest distance beyond its own ε, so the ray's direction is made
/// a unit vector and the distance divided by its length; hits outside [t_min, t_max] are dropped. Source:
/// G-Truc Creation, "OpenGL Mathematics (GLM), gtx/intersect", 2020.
[[nodiscard]] Subject glm_sphere();

}  // namespace rayproof
