/// \file
/// Planes, triangles and polygons.

#include <fmt/format.h>

#include <algorithm>

#include "dossier/by_hand/line.hpp"

namespace rayproof::dossier {
namespace {

/// The image of a point under an affine matrix, whose numbers stand by rows.
FractionVector carried(const std::vector<double>& matrix, const FractionVector& p) {
  const auto row = [&](std::size_t i) {
    return Fraction(Fraction(matrix.at(4 * i)) * p.x + Fraction(matrix.at(4 * i + 1)) * p.y +
                    Fraction(matrix.at(4 * i + 2)) * p.z + Fraction(matrix.at(4 * i + 3)));
  };
  return {row(0), row(1), row(2)};
}

/// t on the plane n·(x - p) = 0; nothing, with a sentence, where the line is parallel.
std::optional<Fraction> t_on_plane(HandCalculation& calculation, const HandLine& line,
                                   const FractionVector& n, const FractionVector& p) {
  const Fraction down = dot(n, line.direction), up = dot(n, p - line.origin);
  if (down == 0) {
    calculation.steps.push_back(
        fmt::format("n·d = 0: the line is parallel to the plane{}.", up == 0 ? " and lies in it" : ""));
    return std::nullopt;
  }
  const Fraction t = up / down;
  calculation.steps.push_back(fmt::format("On the plane, t = n·(p - origin) / n·d = {} / {} = {}.", shown(up),
                                          shown(down), shown(t)));
  return t;
}

}  // namespace

void plane_by_hand(HandCalculation& calculation, const HandLine& line, const NamedNumbers& inputs) {
  const FractionVector n = vector_in(inputs, "normal");
  FractionVector p;
  if (inputs.contains("point")) {
    p = vector_in(inputs, "point");
  } else {
    // The foot of the plane n·x = constant, or n·x + d = 0.
    const Fraction constant =
        inputs.contains("constant") ? fraction_in(inputs, "constant") : Fraction(-fraction_in(inputs, "d"));
    p = Fraction(constant / dot(n, n)) * n;
  }
  calculation.steps.push_back(
      fmt::format("The normal is n = {}, a point of the plane is p = {}.", shown(n), shown(p)));
  if (const auto t = t_on_plane(calculation, line, n, p)) keep_hits(calculation, line, {{*t}});
}

void triangle_by_hand(HandCalculation& calculation, const HandLine& line, const NamedNumbers& inputs) {
  FractionVector a = vector_in(inputs, "a"), b = vector_in(inputs, "b"), c = vector_in(inputs, "c");
  if (inputs.contains("matrix")) {
    for (FractionVector* const corner : {&a, &b, &c}) *corner = carried(inputs.at("matrix"), *corner);
    calculation.steps.push_back(
        fmt::format("The matrix takes the corners to a = {}, b = {}, c = {}.", shown(a), shown(b), shown(c)));
  }
  const FractionVector n = cross(b - a, c - a);
  calculation.steps.push_back(
      fmt::format("The triangle's normal is n = (b - a) × (c - a) = {}, p = a.", shown(n)));
  const auto t = t_on_plane(calculation, line, n, a);
  if (!t) return;
  const FractionVector p = line.at(*t);
  const Fraction area = dot(n, n);
  const Fraction of_b = dot(cross(p - a, c - a), n) / area, of_c = dot(cross(b - a, p - a), n) / area;
  const Fraction of_a = 1 - of_b - of_c;
  const bool is_inside = of_a >= 0 && of_b >= 0 && of_c >= 0;
  calculation.steps.push_back(fmt::format(
      "That point is {} = {}·a + {}·b + {}·c: {}.", shown(p), shown(of_a), shown(of_b), shown(of_c),
      is_inside ? "none is negative, it belongs to the triangle" : "one is negative, it lies outside"));
  if (!is_inside) return;
  calculation.barycentric = {of_b.convert_to<double>(), of_c.convert_to<double>()};
  keep_hits(calculation, line, {{*t}});
}

void polygon_by_hand(HandCalculation& calculation, const HandLine& line, const NamedNumbers& inputs) {
  const std::vector<FractionVector> corners = vectors_in(inputs, "vertices");
  FractionVector n;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    n = n + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  calculation.steps.push_back(fmt::format(
      "The polygon's normal (the sum of its triangles') is n = {}, p its first corner.", shown(n)));
  const auto t = t_on_plane(calculation, line, n, corners.front());
  if (!t) return;
  // Seen along the normal's largest component, the last of several, as the case format has it.
  int axis = 0;
  for (const int other : {1, 2})
    if (abs(n[other]) >= abs(n[axis])) axis = other;
  const auto flat = [&](const FractionVector& v) { return FlatPoint{v[(axis + 1) % 3], v[(axis + 2) % 3]}; };
  std::vector<FlatPoint> outline;
  for (const FractionVector& corner : corners) outline.push_back(flat(corner));
  const FlatPosition position = position_of(flat(line.at(*t)), outline);
  calculation.steps.push_back(
      fmt::format("That point is {}; seen along {}, {}", shown(line.at(*t)), "xyz"[axis], position.sentence));
  if (position.is_inside || position.is_on_boundary) keep_hits(calculation, line, {{*t}});
}

FlatPosition position_of(const FlatPoint& point, const std::vector<FlatPoint>& corners) {
  FlatPosition position;
  unsigned crossed = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const FlatPoint &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const Fraction turn = (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]);
    const auto between = [&](int axis) {
      return std::min(a[axis], b[axis]) <= point[axis] && point[axis] <= std::max(a[axis], b[axis]);
    };
    position.is_on_boundary |= turn == 0 && between(0) && between(1);
    const bool is_upward = a[1] <= point[1] && point[1] < b[1],
               is_downward = b[1] <= point[1] && point[1] < a[1];
    if ((is_upward && turn > 0) || (is_downward && turn < 0)) ++crossed;
  }
  if (position.is_on_boundary) {
    position.sentence = "the point lies on a side.";
    return position;
  }
  position.is_inside = crossed % 2 == 1;
  position.sentence =
      fmt::format("a level ray from the point to the right crosses {} side{}: the point is {}.", crossed,
                  crossed == 1 ? "" : "s", position.is_inside ? "inside" : "outside");
  return position;
}

void position_by_hand(HandCalculation& calculation, const NamedNumbers& inputs) {
  const auto& numbers = inputs.at("vertices");
  std::vector<FlatPoint> corners;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
    corners.push_back({Fraction(numbers[i]), Fraction(numbers[i + 1])});
  const auto& point = inputs.at("point");
  const FlatPosition position = position_of({Fraction(point.at(0)), Fraction(point.at(1))}, corners);
  calculation.is_position = true;
  calculation.is_inside = position.is_inside;
  calculation.is_on_boundary = position.is_on_boundary;
  std::string sentence = position.sentence;
  sentence[0] = static_cast<char>(std::toupper(sentence[0]));
  calculation.steps.push_back(sentence);
}

}  // namespace rayproof::dossier
