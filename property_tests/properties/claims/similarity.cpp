#include "properties/claims/similarity.hpp"

#include <bit>
#include <cmath>
#include <glm/mat4x3.hpp>
#include <rayproof/formulas/finite.hpp>

#include "case/each_number.hpp"
#include "generators/scene.hpp"
#include "properties/numbers.hpp"

namespace rayproof {

namespace {

void scale(RayQuestion& asked, double lengths, double direction) {
  asked.ray.origin *= lengths;
  asked.ray.direction *= direction;
  asked.ray.t_min *= lengths / direction;
  asked.ray.t_max *= lengths / direction;
  if (direction < 0) std::swap(asked.ray.t_min, asked.ray.t_max);
  std::visit([&](auto& shape) { shape = grown(shape, lengths); }, asked.shape);
  if (asked.transform)
    for (int axis = 0; axis < 3; ++axis) (*asked.transform)[3][axis] *= lengths;
}

/// Affine maps of small numbers, by columns: moved, mirrored, turned by a 3-4-5 triangle, stretched, sheared,
/// all of these.
glm::dmat4 affine_map(std::uint64_t choice) {
  const glm::dmat4x3 maps[] = {
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, -2, 3}},          {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}},
      {{0.75, 1, 0}, {-1, 0.75, 0}, {0, 0, 1.25}, {0, 0, 0}}, {{2, 0, 0}, {0, 1, 0}, {0, 0, 0.5}, {0, 0, 0}},
      {{1, 0, 0}, {3, 1, 0}, {0, 0, 1}, {0, 0, 0}},           {{1, 2, 0}, {0, -3, 1}, {2, 0, 1}, {-4, 5, 6}},
  };
  return glm::dmat4(maps[choice % std::size(maps)]);
}

std::uint64_t hash_of(Case one) {
  std::uint64_t hash = 0;
  for (const CaseNumber& number : numbers_of(one))
    hash = combine(hash, std::bit_cast<std::uint64_t>(*number.value));
  return hash;
}

}  // namespace

Twin scaled_twin(const Case& one, double lengths, double whole) {
  Twin twin{one, lengths};
  if (auto* q = std::get_if<Quadratic<double>>(&twin.one.question)) {
    *q = {q->a * whole, q->b * (whole * lengths), q->c * (whole * lengths * lengths)};
  } else if (auto* place = std::get_if<PointAndPolygon<double>>(&twin.one.question)) {
    *place = grown(*place, lengths);
  } else {
    scale(std::get<RayQuestion>(twin.one.question), lengths, whole);
    twin.factor = lengths / whole;
  }
  return twin;
}

Twin reversed_twin(const Case& one) {
  const bool is_equation = std::holds_alternative<Quadratic<double>>(one.question);
  return is_equation ? scaled_twin(one, -1, 1) : scaled_twin(one, 1, -1);
}

std::optional<Case> moved_case(const Case& one) {
  const auto* still = std::get_if<RayQuestion>(&one.question);
  if (still == nullptr || still->transform) return std::nullopt;
  Case moved = one;
  auto& asked = std::get<RayQuestion>(moved.question);
  const glm::dmat4 map = affine_map(hash_of(one));
  const glm::dmat3 linear(map);
  asked.transform = map;
  asked.ray.origin = rounded(one.precision, linear * asked.ray.origin + glm::dvec3(map[3]));
  asked.ray.direction = rounded(one.precision, linear * asked.ray.direction);
  // A ray that the map takes beyond the greatest number is no case.
  if (!are_finite(asked.ray.origin, asked.ray.direction)) return std::nullopt;
  return moved;
}

}  // namespace rayproof
