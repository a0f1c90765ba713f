/// \file
/// Spheres, boxes and cylinders.

#include <fmt/format.h>

#include <algorithm>

#include "dossier/by_hand/line.hpp"

namespace rayproof::dossier {
namespace {

/// The t between which something holds; nothing where it never does, ends left out where there are none.
struct HandInterval {
  bool is_empty = false;
  std::optional<HandNumber> from{}, to{};

  [[nodiscard]] std::string text() const {
    if (is_empty) return "for no t";
    if (!from && !to) return "for all t";
    return fmt::format("for {}t{}", from ? shown(*from) + " ≤ " : "", to ? " ≤ " + shown(*to) : "");
  }
  void cut(const HandInterval& other) {
    is_empty |= other.is_empty;
    if (other.from && (!from || from->value < other.from->value)) from = other.from;
    if (other.to && (!to || other.to->value < to->value)) to = other.to;
    is_empty |= from && to && to->value < from->value;
  }
};

/// Where low ≤ o + t·d ≤ high.
HandInterval slab(const Fraction& o, const Fraction& d, const Fraction& low, const Fraction& high) {
  if (d == 0) return {.is_empty = o < low || high < o};
  Fraction from = (low - o) / d, to = (high - o) / d;
  if (to < from) std::swap(from, to);
  return {.from = HandNumber{from}, .to = HandNumber{to}};
}

/// Where a t² + 2 b t + c ≤ 0, for a ≥ 0, with the calculation.
HandInterval quadratic_interval(HandCalculation& calculation, const std::string& name, const Fraction& a,
                                const Fraction& b, const Fraction& c) {
  calculation.steps.push_back(
      fmt::format("{} at most where a·t² + 2b·t + c ≤ 0, with a = {}, b = {}, c = {}.", name, shown(a),
                  shown(b), shown(c)));
  if (a == 0) return {.is_empty = c > 0};
  const Fraction discriminant = b * b - a * c;
  if (discriminant < 0) {
    calculation.steps.push_back(fmt::format("b² - a·c = {} is negative: for no t.", shown(discriminant)));
    return {.is_empty = true};
  }
  const HandNumber root = root_of(discriminant);
  const HandNumber from{(-b - root.value) / a, root.is_rational}, to{(-b + root.value) / a, root.is_rational};
  calculation.steps.push_back(fmt::format(
      "b² - a·c = {}, so for t from (-b - √(b² - a·c)) / a, which is {}, to (-b + √(b² - a·c)) / a, {}.",
      shown(discriminant), shown(from), shown(to)));
  return {.from = from, .to = to};
}

/// The ends of the interval are the hits.
void keep_ends(HandCalculation& calculation, const HandLine& line, const HandInterval& inside) {
  if (inside.is_empty) {
    calculation.steps.emplace_back("So the line misses it.");
    return;
  }
  std::vector<HandNumber> ends;
  if (inside.from) ends.push_back(*inside.from);
  if (inside.to && (!inside.from || inside.to->value != inside.from->value)) ends.push_back(*inside.to);
  keep_hits(calculation, line, ends);
}

}  // namespace

void sphere_by_hand(HandCalculation& calculation, const HandLine& line, const NamedNumbers& inputs) {
  const FractionVector l = line.origin - vector_in(inputs, "center");
  Fraction square;
  if (inputs.contains("radius2")) {
    square = fraction_in(inputs, "radius2");
  } else {
    square = fraction_in(inputs, "radius");
    square *= square;
  }
  const Fraction a = dot(line.direction, line.direction), b = dot(line.direction, l), c = dot(l, l) - square;
  keep_ends(calculation, line,
            quadratic_interval(calculation, "With L = origin - center, |L + t·d|² is r²", a, b, c));
}

void box_by_hand(HandCalculation& calculation, const HandLine& line, const NamedNumbers& inputs) {
  FractionVector low, high;
  if (inputs.contains("low")) {
    low = vector_in(inputs, "low"), high = vector_in(inputs, "high");
  } else {
    const FractionVector center = vector_in(inputs, "center");
    const FractionVector half =
        inputs.contains("half") ? vector_in(inputs, "half") : Fraction(1, 2) * vector_in(inputs, "sides");
    low = center - half, high = center + half;
  }
  HandInterval inside;
  for (int axis = 0; axis < 3; ++axis) {
    const HandInterval own = slab(line.origin[axis], line.direction[axis], low[axis], high[axis]);
    calculation.steps.push_back(
        fmt::format("{} ≤ {} ≤ {} {}.", shown(low[axis]), "xyz"[axis], shown(high[axis]), own.text()));
    inside.cut(own);
  }
  keep_ends(calculation, line, inside);
}

void cylinder_by_hand(HandCalculation& calculation, const HandLine& line, const NamedNumbers& inputs) {
  const FractionVector center = vector_in(inputs, "center"), o = line.origin - center;
  const bool has_half = inputs.contains("half");
  const Fraction r = has_half ? vector_in(inputs, "half").x : fraction_in(inputs, "radius");
  const Fraction half = has_half ? vector_in(inputs, "half").z : Fraction(fraction_in(inputs, "height") / 2);
  const FractionVector& d = line.direction;
  HandInterval inside =
      quadratic_interval(calculation, "About the axis, x² + y² is r²", d.x * d.x + d.y * d.y,
                         o.x * d.x + o.y * d.y, o.x * o.x + o.y * o.y - r * r);
  const HandInterval between = slab(o.z, d.z, -half, half);
  calculation.steps.push_back(fmt::format("Between the caps, {} ≤ z ≤ {}, {}.",
                                          shown(Fraction(center.z - half)), shown(Fraction(center.z + half)),
                                          between.text()));
  inside.cut(between);
  keep_ends(calculation, line, inside);
}

}  // namespace rayproof::dossier
