#pragma once
/// \file
/// Readings of a case that mix up the coordinates of its points and directions.

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// Some of a ray question's vectors.
enum class Vectors {
  points,      ///< of the shape
  directions,  ///< of the shape: normals, edges, what spans a plane
  origin,
  direction
};

/// The case with each of these vectors changed.
[[nodiscard]] std::vector<Case> with_vectors(const Case& one, Vectors which, void (*change)(glm::dvec3&));

/// Two coordinates of each of these vectors are exchanged.
template <Vectors which, int i, int j>
[[nodiscard]] std::vector<Case> exchanged(const Case& one) {
  return with_vectors(one, which, [](glm::dvec3& v) { std::swap(v[i], v[j]); });
}
/// One coordinate of each of these vectors is read in the place of another.
template <Vectors which, int from, int to>
[[nodiscard]] std::vector<Case> copied(const Case& one) {
  return with_vectors(one, which, [](glm::dvec3& v) { v[to] = v[from]; });
}
/// One coordinate of each of these vectors is read as 0.
template <Vectors which, int i>
[[nodiscard]] std::vector<Case> without(const Case& one) {
  return with_vectors(one, which, [](glm::dvec3& v) { v[i] = 0; });
}
/// One coordinate of the ray's origin in the object's space is read as 0.
template <int i>
[[nodiscard]] std::vector<Case> without_coordinate(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    asked.ray = ray_in_object(asked);
    asked.transform.reset();
    asked.ray.origin[i] = 0;
    return true;
  });
}
/// The shape is moved so that its first point is the origin of coordinates, and the ray is not.
[[nodiscard]] std::vector<Case> place_ignored(const Case& one);
/// These vectors have the other sign.
template <Vectors which>
[[nodiscard]] std::vector<Case> negated(const Case& one) {
  return with_vectors(one, which, [](glm::dvec3& v) { v = -v; });
}
/// These vectors are read as whole numbers, cut off towards 0.
template <Vectors which>
[[nodiscard]] std::vector<Case> truncated(const Case& one) {
  return with_vectors(one, which, [](glm::dvec3& v) { v = glm::trunc(v); });
}

/// Every number of the shape is changed; of a point and a polygon, those of both.
[[nodiscard]] std::vector<Case> with_numbers_of_shape(const Case& one, double (*change)(double x));
/// Each rounded to a grid with that number of cells for each unit of length.
template <int cells>
[[nodiscard]] std::vector<Case> shape_on_grid(const Case& one) {
  return with_numbers_of_shape(one, [](double x) { return on_grid(x, cells); });
}
/// Whether something but 0 is left of a number of the shape that is moved so.
[[nodiscard]] bool has_moved_number(const Case& one, double (*change)(double x));
template <int cells>
[[nodiscard]] bool has_number_on_grid(const Case& one, const Answer& /*exact*/) {
  return has_moved_number(one, [](double x) { return on_grid(x, cells); });
}
/// Every number that the case writes with an exponent is read without it: 1e-07 as 1.
[[nodiscard]] std::vector<Case> without_exponents(const Case& one);
/// What a subject answers that reads the case's whole numbers, those without point and exponent, as integers
/// of 32 bits: what does not fit wraps round, or becomes the nearest that fits, or the least. An answer for
/// each.
[[nodiscard]] Answers whole_numbers_in_32_bits(const Case& one, const Answer& exact);
/// @{ As whole numbers, cut off towards 0; as those of the shorter type, or of 11 bits, as half floats have.
[[nodiscard]] inline std::vector<Case> shape_cut_off(const Case& one) {
  return with_numbers_of_shape(one, [](double x) { return std::trunc(x); });
}
[[nodiscard]] inline std::vector<Case> numbers_in_float(const Case& one) {
  return with_numbers_of_shape(one, [](double x) { return double{static_cast<float>(x)}; });
}
[[nodiscard]] inline std::vector<Case> numbers_in_half(const Case& one) {
  return with_numbers_of_shape(one, [](double x) {
    constexpr double largest = 65504, quantum = 0x1p-24;
    const double unit = std::max(quantum, x == 0 ? quantum : std::ldexp(1, std::ilogb(x) - 10));
    return std::clamp(std::nearbyint(x / unit) * unit, -largest, largest);
  });
}
/// @}

/// @{ The ray starts at the origin of coordinates; its direction is taken for a point that it goes through; x
/// and y of the point in the plane are exchanged.
[[nodiscard]] std::vector<Case> without_origin(const Case& one);
/// d for o; and where a component of d that is 0 is looked at apart, for the others alone.
[[nodiscard]] std::vector<Case> direction_as_origin(const Case& one);
[[nodiscard]] std::vector<Case> direction_as_target(const Case& one);
/// The shape's place, its first point, is subtracted from the direction as it is from the origin.
[[nodiscard]] std::vector<Case> direction_from_shape(const Case& one);
[[nodiscard]] std::vector<Case> point_exchanged(const Case& one);

/// The case with x and y of the point in a polygon changed; none where it asks no such thing.
[[nodiscard]] std::vector<Case> with_point(const Case& one, double (*change)(double x, double cells),
                                           double cells);
/// What a subject answers that reads the case so; anything where the changed point lies on the boundary, and
/// nothing where the given one does, too: such an answer is another fault's.
template <std::vector<Case> (*changes)(const Case&)>
[[nodiscard]] Answers off_boundary_read_as(const Case& one, const Answer& exact) {
  Answers answers = read_as<changes>(one, exact);
  const auto is_boundary = [](const Answer& answer) {
    const auto* position = std::get_if<Position>(&answer);
    return position != nullptr && *position == Position::boundary;
  };
  if (!std::ranges::any_of(answers, is_boundary)) return answers;
  if (is_boundary(exact)) return {};
  return {Position::outside, Position::boundary, Position::inside};
}
/// What a subject answers that reads the shape's numbers, and a point's, as integers. A polygon that has no
/// area then holds no point.
[[nodiscard]] Answers with_shape_cut_off(const Case& one, const Answer& exact);
/// What a subject answers that keeps the shape's numbers, and a point's, as floats. One that is too large for
/// them is infinite, and mostly nothing is hit then.
[[nodiscard]] Answers with_shape_in_float(const Case& one, const Answer& exact);
/// Whether a polygon in the plane keeps some area so; of other shapes always.
[[nodiscard]] bool has_area_cut_off(const Case& one, const Answer& exact);
/// That point cut off to whole numbers.
[[nodiscard]] std::vector<Case> point_cut_off(const Case& one);
/// That point moved to a grid with that number of cells for each unit of length.
template <int cells>
[[nodiscard]] std::vector<Case> point_on_grid(const Case& one) {
  return with_point(
      one, [](double x, double n) { return on_grid(x, n); }, cells);
}
/// @}

}  // namespace rayproof::diagnosis
