#include "dossier/by_hand/line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

namespace rayproof::dossier {
namespace {

/// The end of an interval: what is given, or what holds where nothing is.
std::optional<Fraction> end_in(const NamedNumbers& inputs, const std::string& name,
                               std::optional<Fraction> usual) {
  const auto given = inputs.find(name);
  if (given == inputs.end()) return usual;
  if (given->second.size() != 1 || !std::isfinite(given->second[0])) return std::nullopt;
  return Fraction(given->second[0]);
}

}  // namespace

std::string HandLine::range() const {
  if (!t_min && !t_max) return "all t";
  return (t_min ? shown(*t_min) + " ≤ " : "") + "t" + (t_max ? " ≤ " + shown(*t_max) : "");
}

HandLine line_in(const NamedNumbers& inputs) {
  HandLine line;
  line.is_segment = inputs.contains("start");
  line.origin = vector_in(inputs, line.is_segment ? "start" : "origin");
  line.direction = line.is_segment ? vector_in(inputs, "end") - line.origin : vector_in(inputs, "direction");
  std::optional<Fraction> last;
  if (line.is_segment) last = Fraction(1);
  // A ray of a length ends there; its direction is as long, but for a rounding, which no hit is near.
  if (inputs.contains("length")) last = Fraction(1);
  line.t_min = end_in(inputs, "t_min", Fraction(0));
  line.t_max = end_in(inputs, "t_max", last);
  return line;
}

void keep_hits(HandCalculation& calculation, const HandLine& line, const std::vector<HandNumber>& all) {
  std::vector<std::string> texts;
  for (const HandNumber& t : all) {
    texts.push_back(shown(t));
    if (!line.counts(t.value)) continue;
    calculation.hits.push_back(t.value.convert_to<double>());
    calculation.hits_as_text.push_back(shown(t));
  }
  if (all.empty()) return;
  const std::string counted = calculation.hits_as_text.empty()
                                  ? "none of them"
                                  : fmt::format("{}", fmt::join(calculation.hits_as_text, " and "));
  calculation.steps.push_back(fmt::format("The line meets it where t is {}; with {}, {} count{}.",
                                          fmt::join(texts, " and "), line.range(), counted,
                                          calculation.hits_as_text.size() == 1 ? "s" : ""));
}

HandCalculation by_hand(const std::string& topic, const NamedNumbers& inputs) {
  HandCalculation calculation;
  if (topic == "point_in_polygon") {
    position_by_hand(calculation, inputs);
    return calculation;
  }
  const HandLine line = line_in(inputs);
  if (line.is_segment)
    calculation.steps.push_back(
        fmt::format("The line is start + t·d with d = end - start = {}.", shown(line.direction)));
  if (inputs.contains("length"))
    calculation.steps.emplace_back("The line is origin + t·d, d the direction; the depth is t·|d|.");
  using Formula = void (*)(HandCalculation&, const HandLine&, const NamedNumbers&);
  static const std::map<std::string, Formula> formulas{
      {"sphere", sphere_by_hand},   {"plane", plane_by_hand}, {"triangle", triangle_by_hand},
      {"polygon", polygon_by_hand}, {"box", box_by_hand},     {"cylinder", cylinder_by_hand}};
  const auto formula = formulas.find(topic);
  if (formula == formulas.end()) throw std::runtime_error("there is no formula for " + topic);
  formula->second(calculation, line, inputs);
  return calculation;
}

}  // namespace rayproof::dossier
