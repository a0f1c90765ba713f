#include "dossier/comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <optional>

namespace rayproof::dossier {
namespace {

std::optional<double> said(const Reproduction& library, const std::string& name) {
  const auto found = library.said.find(name);
  if (found == library.said.end() || found->second.size() != 1) return std::nullopt;
  return found->second[0];
}

/// Where rounding alone may take a right answer, in units of what it is rounded from.
double tolerance_of(Precision precision) {
  const double epsilon = precision == Precision::float32
                             ? static_cast<double>(std::numeric_limits<float>::epsilon())
                             : std::numeric_limits<double>::epsilon();
  return 32 * epsilon;
}

double length_of(const std::vector<double>& v) {
  double square = 0;
  for (const double x : v) square += x * x;
  return std::sqrt(square);
}

/// A t of the library in the units of the calculation; nothing where it gives none.
std::optional<double> t_said(const Reproduction& library) {
  for (const char* const name : {"t", "fraction", "t1"})
    if (const auto t = said(library, name)) return t;
  // A distance along the direction.
  for (const char* const name : {"depth", "distance"})
    if (const auto depth = said(library, name)) return *depth / length_of(library.inputs.at("direction"));
  const auto x = said(library, "x"), y = said(library, "y"), z = said(library, "z");
  if (!x || !y || !z) return std::nullopt;
  const bool is_segment = library.inputs.contains("start");
  const auto& o = library.inputs.at(is_segment ? "start" : "origin");
  std::vector<double> d = library.inputs.at(is_segment ? "end" : "direction");
  for (std::size_t i = 0; is_segment && i < 3; ++i) d[i] -= o[i];
  const double square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  return ((*x - o[0]) * d[0] + (*y - o[1]) * d[1] + (*z - o[2]) * d[2]) / square;
}

/// What the library measures a hit by, and how much of it is one t of the calculation.
struct Quantity {
  const char* name;
  double factor;
};

Quantity quantity_of(const Reproduction& library) {
  for (const char* const name : {"depth", "distance"})
    if (library.said.contains(name)) return {name, length_of(library.inputs.at("direction"))};
  return {library.said.contains("fraction") ? "fraction" : "t", 1};
}

/// "t = 1/2 and 1", "depth ≈ 0.1".
std::string places(const HandCalculation& right, const Quantity& quantity) {
  std::vector<std::string> texts = right.hits_as_text;
  for (std::size_t i = 0; i < texts.size() && quantity.factor != 1; ++i)
    texts[i] = "≈ " + fmt::format("{}", right.hits[i] * quantity.factor);
  const std::string list = fmt::format("{}", fmt::join(texts, " and "));
  return quantity.name + std::string(list.starts_with("≈") ? " " : " = ") + list;
}

/// A title's digits: as few as distinguish the number from the other one.
int digits_apart(double x, double other) {
  int digits = 6;
  while (digits < 17 && fmt::format("{:.{}g}", x, digits) == fmt::format("{:.{}g}", other, digits)) ++digits;
  return digits;
}

/// "= 0.5", "≈ 0.73728": what a title says of a number.
std::string in_title(double x, int digits) {
  const std::string whole = fmt::format("{}", x), cut = fmt::format("{:.{}g}", x, digits);
  return whole.size() <= cut.size() ? "= " + whole : "≈ " + cut;
}

/// The same of the nearest hit, with its name: "t = 9/112", "depth ≈ 0.1".
std::string place_in_title(const HandCalculation& right, const Quantity& quantity, int digits) {
  constexpr std::size_t few = 9;
  const std::string& text = right.hits_as_text.front();
  const std::string name = std::string(quantity.name) + " ";
  if (quantity.factor == 1 && text.size() <= few && !text.starts_with("≈")) return name + "= " + text;
  const double place = right.hits.front() * quantity.factor;
  return name + (quantity.factor == 1 ? in_title(place, digits) : fmt::format("≈ {:.{}g}", place, digits));
}

/// "a triangle", "a plane".
std::string named(const std::string& shape) { return "a " + shape; }

Comparison compare_positions(const HandCalculation& right, const Reproduction& library) {
  Comparison made;
  made.expected = right.is_on_boundary ? "on the boundary" : right.is_inside ? "inside" : "outside";
  bool is_inside = false, is_boundary = false;
  for (const char* const name : {"inside", "within", "contains", "side"})
    is_inside |= said(library, name).value_or(0) == 1;
  for (const char* const name : {"covered_by", "covers"})
    is_boundary |= !is_inside && said(library, name).value_or(0) == 1;
  if (const auto side = said(library, "side")) is_boundary = *side == 0;
  const bool knows_boundary = !library.said.contains("inside");
  made.is_wrong =
      right.is_on_boundary ? knows_boundary && !is_boundary : is_inside != right.is_inside || is_boundary;
  made.deed = fmt::format("calls a point {} that is {}",
                          is_boundary ? "on the boundary"
                          : is_inside ? "inside"
                                      : "outside",
                          right.is_on_boundary ? "on the boundary"
                          : right.is_inside    ? "inside the polygon"
                                               : "outside the polygon");
  return made;
}

/// What is wrong with the numbers of a hit that there is.
void compare_numbers(Comparison& made, const HandCalculation& right, const Reproduction& library,
                     Precision precision) {
  const double tolerance = tolerance_of(precision);
  const auto differ = [&](double got, double exact) {
    return !(std::abs(got - exact) <= tolerance * std::max(std::abs(exact), 1e-300));
  };
  if (const auto t = t_said(library); t && differ(*t, right.hits.front())) {
    made.is_wrong = true;
    const Quantity quantity = quantity_of(library);
    const double given = *t * quantity.factor;
    const int digits = digits_apart(given, right.hits.front() * quantity.factor);
    made.deed = fmt::format("gives {} {} for a hit at {}", quantity.name, in_title(given, digits),
                            place_in_title(right, quantity, digits));
    return;
  }
  const auto u = said(library, "u"), v = said(library, "v");
  if (!u || !v || right.barycentric.empty()) return;
  const bool is_off = !(std::abs(*u - right.barycentric[0]) <= tolerance) ||
                      !(std::abs(*v - right.barycentric[1]) <= tolerance);
  made.is_wrong = is_off;
  made.deed = fmt::format("gives barycentric coordinates ({}, {}) for ({}, {})", *u, *v, right.barycentric[0],
                          right.barycentric[1]);
}

}  // namespace

Comparison compare(const HandCalculation& right, const Reproduction& library, const std::string& shape,
                   Precision precision) {
  Comparison made;
  if (right.is_position) {
    made = compare_positions(right, library);
  } else {
    const Quantity quantity = quantity_of(library);
    made.expected = right.is_hit() ? "a hit at " + places(right, quantity) : "no hit";
    const auto t = said(library, "t");
    const bool is_hit = said(library, "hit").value_or(t && std::isfinite(*t) ? 1 : 0) != 0;
    if (is_hit != right.is_hit()) {
      made.is_wrong = true;
      const auto at = t_said(library);
      constexpr int digits = 6;
      made.deed = right.is_hit() ? fmt::format("misses {} that is hit at {}", named(shape),
                                               place_in_title(right, quantity, digits))
                  : at ? fmt::format("hits {} at {} {} where there is no hit", named(shape), quantity.name,
                                     in_title(*at * quantity.factor, digits))
                       : fmt::format("hits {} where there is no hit", named(shape));
    } else if (is_hit) {
      compare_numbers(made, right, library, precision);
    }
  }
  if (!library.has_returned) {
    made.is_wrong = true;
    made.deed = (library.ending == "did not return" ? "does not return, asked for "
                                                    : "ends the program, asked for ") +
                named(right.is_position ? "point in a polygon" : shape);
  }
  return made;
}

}  // namespace rayproof::dossier
