#include "properties/diagnosis/models/space/transform.hpp"

namespace rayproof::diagnosis {
namespace {

/// Changes the ray and the transform, `map`, of a case that has one.
template <class DoChange>
std::vector<Case> with_map(const Case& one, DoChange&& change) {
  return with_question(one, [&](RayQuestion& asked) {
    if (!asked.transform) return false;
    change(asked, *asked.transform);
    return true;
  });
}

}  // namespace

std::vector<Case> without_transform(const Case& one) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr || !asked->transform) return {};
  return with_question(one, [](RayQuestion& changed) {
    changed.transform.reset();
    return true;
  });
}

std::vector<Case> with_inverse_transform(const Case& one) {
  return with_map(one, [](RayQuestion& /*asked*/, glm::dmat4& map) {
    const glm::dmat3 inverse = glm::inverse(glm::dmat3(map));
    const glm::dvec3 translation = -(inverse * glm::dvec3(map[3]));
    map = glm::dmat4(inverse);
    map[3] = glm::dvec4(translation, 1);
  });
}

std::vector<Case> with_transposed_transform(const Case& one) {
  std::vector<Case> all;
  for (const double kept : {0.0, 1.0}) {
    for (const Case& some : with_map(one, [&](RayQuestion& /*asked*/, glm::dmat4& map) {
           const glm::dvec3 translation = kept * glm::dvec3(map[3]);
           map = glm::dmat4(glm::transpose(glm::dmat3(map)));
           map[3] = glm::dvec4(translation, 1);
         }))
      all.push_back(some);
  }
  return all;
}

std::vector<Case> diagonal_alone(const Case& one) {
  return with_map(one, [](RayQuestion& /*asked*/, glm::dmat4& map) {
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 3; ++row)
        if (row != column) map[column][row] = 0;
  });
}

std::vector<Case> translation_negated(const Case& one) {
  return with_map(
      one, [](RayQuestion& /*asked*/, glm::dmat4& map) { map[3] = glm::dvec4(-glm::dvec3(map[3]), 1); });
}

std::vector<Case> translation_undone_last(const Case& one) {
  return with_map(one, [](RayQuestion& /*asked*/, glm::dmat4& map) {
    map[3] = glm::dvec4(glm::dmat3(map) * glm::dvec3(map[3]), 1);
  });
}

std::vector<Case> without_translation(const Case& one) {
  return with_map(one, [](RayQuestion& /*asked*/, glm::dmat4& map) { map[3] = glm::dvec4(0, 0, 0, 1); });
}

std::vector<Case> direction_as_point(const Case& one) {
  return with_map(
      one, [](RayQuestion& asked, const glm::dmat4& map) { asked.ray.direction -= glm::dvec3(map[3]); });
}

std::vector<Case> origin_not_transformed(const Case& one) {
  return with_map(one, [](RayQuestion& asked, const glm::dmat4& map) {
    asked.ray.origin = glm::dvec3(map * glm::dvec4(asked.ray.origin, 1));
  });
}

std::vector<Case> direction_by_matrix(const Case& one) {
  return with_map(one, [](RayQuestion& asked, const glm::dmat4& map) {
    asked.ray.direction = glm::dmat3(map) * (glm::dmat3(map) * asked.ray.direction);
  });
}

std::vector<Case> origin_by_matrix(const Case& one) {
  return with_map(one, [](RayQuestion& asked, const glm::dmat4& map) {
    asked.ray.origin = glm::dvec3(map * (map * glm::dvec4(asked.ray.origin, 1)));
  });
}

std::vector<Case> inverse_undivided(const Case& one) {
  return with_map(one, [](RayQuestion& asked, const glm::dmat4& map) {
    const double size = glm::determinant(glm::dmat3(map));
    const Ray<double> ray = ray_in_object(asked);
    asked.ray.origin = glm::dvec3(map * glm::dvec4(size * ray.origin, 1));
    asked.ray.direction = glm::dmat3(map) * (size * ray.direction);
  });
}

std::vector<Case> direction_not_transformed(const Case& one) {
  return with_map(one, [](RayQuestion& asked, const glm::dmat4& map) {
    asked.ray.direction = glm::dmat3(map) * asked.ray.direction;
  });
}

}  // namespace rayproof::diagnosis
