#pragma once
/// \file
/// Motions that round nothing: axes exchanged and mirrored, lengths times a power of two, and steps by whole
/// numbers. Each moves a question in two forms: by the shape's own fields, or by its transform.

#include <algorithm>

#include "case/answer.hpp"
#include "case/case.hpp"
#include "case/each_number.hpp"
#include "case/independent.hpp"
#include "properties/numbers.hpp"

namespace rayproof::oracle::test {

/// Coordinate i of the moved vector is sign[i] times coordinate axis[i].
struct Motion {
  std::array<int, 3> axis{0, 1, 2};
  glm::dvec3 sign{1, 1, 1};

  [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& v) const {
    return sign * glm::dvec3(v[axis[0]], v[axis[1]], v[axis[2]]);
  }
  [[nodiscard]] bool keeps_axes() const { return axis == std::array{0, 1, 2}; }
  /// -1 where the motion makes a left hand of a right one.
  [[nodiscard]] double determinant() const {
    const bool is_even = axis[1] == (axis[0] + 1) % 3;
    return sign.x * sign.y * sign.z * (is_even ? 1 : -1);
  }
};

inline constexpr std::array motions{Motion{{1, 2, 0}, {1, 1, 1}}, Motion{{2, 1, 0}, {1, 1, 1}},
                                    Motion{{0, 1, 2}, {-1, 1, 1}}, Motion{{1, 0, 2}, {-1, -1, -1}}};

[[nodiscard]] inline Ray<double> moved(const Ray<double>& ray, const Motion& motion) {
  return {motion(ray.origin), motion(ray.direction), ray.t_min, ray.t_max};
}

/// Ray and shape moved, the shape by its transform.
[[nodiscard]] inline RayQuestion moved_by_transform(RayQuestion asked, const Motion& motion) {
  asked.ray = moved(asked.ray, motion);
  glm::dmat4 map = asked.transform.value_or(glm::dmat4(1));
  for (int column = 0; column < 4; ++column)
    map[column] = glm::dvec4(motion(glm::dvec3(map[column])), map[column].w);
  asked.transform = map;
  return asked;
}

/// Calls `act` for every vector among the shape's fields.
template <class V, class Act>
void each_vector(V& value, Act&& act) {
  if constexpr (std::is_same_v<V, glm::dvec3>) {
    act(value);
  } else if constexpr (requires { ShapeFormat<V>::type; }) {
    ShapeFormat<V>::fields(value, [&](const char* /*name*/, auto& field) { each_vector(field, act); });
  } else if constexpr (!std::is_arithmetic_v<V>) {
    for (auto& element : value) each_vector(element, act);
  }
}

template <class S>
[[nodiscard]] S moved(S shape, const Motion& motion) {
  each_vector(shape, [&](glm::dvec3& v) { v = motion(v); });
  if constexpr (std::is_same_v<S, Box<double>>) {
    const glm::dvec3 corner = shape.min;
    shape.min = glm::min(corner, shape.max);
    shape.max = glm::max(corner, shape.max);
  }
  return shape;
}

/// Ray and shape moved, the shape by its own fields and its transform with them: P·M·P⁻¹.
[[nodiscard]] inline RayQuestion moved_by_fields(RayQuestion asked, const Motion& motion) {
  asked.ray = moved(asked.ray, motion);
  asked.shape = std::visit([&](const auto& shape) -> Shape { return moved(shape, motion); }, asked.shape);
  if (!asked.transform) return asked;
  glm::dmat4 map(1);
  for (int column = 0; column < 3; ++column) {
    const glm::dvec3 old((*asked.transform)[motion.axis[static_cast<std::size_t>(column)]]);
    map[column] = glm::dvec4(motion.sign[column] * motion(old), 0);
  }
  map[3] = glm::dvec4(motion(glm::dvec3((*asked.transform)[3])), 1);
  asked.transform = map;
  return asked;
}

/// Whether every number of the case is a sixteenth of a whole one and below 2^20: sums of a few are exact.
[[nodiscard]] inline bool is_short(Case one) {
  const std::vector<CaseNumber> numbers = numbers_of(one);
  return std::all_of(numbers.begin(), numbers.end(), [](const CaseNumber& number) {
    const double x = *number.value;
    return std::isinf(x) || (std::abs(x) < 0x1p+20 && 16 * x == std::floor(16 * x));
  });
}

/// Whether all numbers, in the case and in its answer, keep their digits in both precisions when scaled.
[[nodiscard]] inline bool is_scalable(Case one, const RayAnswer& found) {
  const auto is_middling = [](double x) {
    return x == 0 || std::isinf(x) || (std::abs(x) > 0x1p-100 && std::abs(x) < 0x1p+100);
  };
  for (const CaseNumber& number : numbers_of(one))
    if (!is_middling(*number.value)) return false;
  for (const double t : found.hits.view())
    if (!is_middling(t) || std::isinf(t)) return false;
  if (!found.point) return true;
  return is_middling(found.point->x) && is_middling(found.point->y) && is_middling(found.point->z);
}

/// Whether a polygon of short numbers lies in a plane. (One that does not has its projection's axis to mind,
/// which a tie gives to the later one.)
[[nodiscard]] inline bool is_flat(const Polygon<double>& polygon) {
  const auto& v = polygon.vertices;
  for (std::size_t i = 1; i < v.size(); ++i)
    for (std::size_t j = i + 1; j < v.size(); ++j)
      for (std::size_t k = j + 1; k < v.size(); ++k)
        if (are_independent(v[i] - v[0], v[j] - v[0], v[k] - v[0])) return false;
  return true;
}

}  // namespace rayproof::oracle::test
