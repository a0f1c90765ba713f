#pragma once
/// \file
/// The normals that a surface has at the first hit, as the models of wrong ones need them: in doubles.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// The part of a transform that takes directions to the world; the identity where there is none.
[[nodiscard]] inline glm::dmat3 linear(const RayQuestion& asked) {
  return glm::dmat3(asked.transform.value_or(glm::dmat4(1)));
}

/// How normals are taken from the object to the world.
[[nodiscard]] inline glm::dmat3 map_of_normals(const RayQuestion& asked) {
  return glm::inverse(glm::transpose(linear(asked)));
}

/// A normal as it is in the object's space, of any length.
[[nodiscard]] inline glm::dvec3 normal_in_object_space(const RayQuestion& asked, const glm::dvec3& normal) {
  return glm::transpose(linear(asked)) * normal;
}

/// The normal of the exact first hit, in the world. On an edge of a solid, where the exact answer has none,
/// those of all faces that meet there: a subject may give any of them. Empty of a miss.
[[nodiscard]] std::vector<glm::dvec3> normals_of_first_hit(const Case& one, const Answer& exact);

/// The exact answer with another normal, `change(question, normal)` of each of those, made a unit vector;
/// none where it is 0.
template <class DoChange>
[[nodiscard]] Answers with_normal(const Case& one, const Answer& exact, DoChange&& change) {
  Answers answers;
  for (const glm::dvec3& own : normals_of_first_hit(one, exact)) {
    const glm::dvec3 normal = change(*ray_question(one), own);
    if (normal == glm::dvec3(0)) continue;
    RayAnswer other = std::get<RayAnswer>(exact);
    other.normal = glm::normalize(normal);
    answers.emplace_back(other);
  }
  return answers;
}

}  // namespace rayproof::diagnosis
