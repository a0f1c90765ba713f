#include "viz/walkthrough/stage_values.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "viz/trace/numbers.hpp"
#include "viz/trace/vector_formula.hpp"

namespace rayproof::viz {
namespace {

/// "f" and 'x' of "f.x".
bool is_component(const std::string& name, char axis) {
  return name.size() > 2 && name[name.size() - 2] == '.' && name.back() == axis;
}

/// The texts of a value's components; a vector's in parentheses.
template <class Text>
std::string joined(const StageValue& value, Text text_of) {
  std::string text;
  for (const WalkValue& component : value.components) {
    text += (text.empty() ? "" : ", ") + text_of(component);
  }
  return value.components.size() > 1 ? "(" + text + ")" : text;
}

std::vector<std::string> formulas_of(const StageValue& value) {
  std::vector<std::string> formulas;
  for (const WalkValue& component : value.components) formulas.push_back(component.formula);
  return formulas;
}

/// The rounded number or vector of a name known by now, as it stands in a formula; empty for no such name. A
/// kernel that goes on in a plane may name the first two components of a vector anew.
std::string number_for(const NumbersByName& n, const std::string& name, Precision precision,
                       std::size_t dimensions) {
  if (n.has(name)) {
    const std::string text = shown(n.rounded(name), precision);
    return text.starts_with('-') ? "(" + text + ")" : text;
  }
  if (!n.has_vector(name)) return {};
  const auto at = [&](const char* axis) { return shown(n.rounded(name + axis), precision); };
  return dimensions > 2 && n.has(name + ".z") ? fmt::format("({}, {}, {})", at(".x"), at(".y"), at(".z"))
                                              : fmt::format("({}, {})", at(".x"), at(".y"));
}

}  // namespace

void put_numbers_in(StageValue& value, const NumbersByName& n, Precision precision) {
  if (value.components.size() == 1) {
    value.formula = value.components[0].formula;
    value.put_in = value.components[0].put_in;
    return;
  }
  value.formula = vector_formula(formulas_of(value));
  value.put_in = put_in(value.formula, [&](const std::string& name) {
    return number_for(n, name, precision, value.components.size());
  });
}

std::vector<StageValue> grouped(const std::vector<WalkValue>& values) {
  std::vector<StageValue> groups;
  for (const WalkValue& value : values) {
    const bool continues = !groups.empty() && !groups.back().components.empty() &&
                           (is_component(value.name, 'y') || is_component(value.name, 'z')) &&
                           value.name.substr(0, value.name.size() - 2) == groups.back().name;
    if (continues) {
      groups.back().components.push_back(value);
      continue;
    }
    StageValue group;
    group.name = is_component(value.name, 'x') ? value.name.substr(0, value.name.size() - 2) : value.name;
    group.components = {value};
    groups.push_back(std::move(group));
  }
  return groups;
}

std::string shown(const StageValue& value, Precision precision) {
  return joined(value, [&](const WalkValue& component) { return shown(component.value, precision); });
}

std::string exact_of(const StageValue& value) {
  return joined(value, [](const WalkValue& component) { return component.exact; });
}

const WalkValue& worst_component(const StageValue& value) {
  return *std::max_element(value.components.begin(), value.components.end(),
                           [](const WalkValue& a, const WalkValue& b) { return a.bits_lost < b.bits_lost; });
}

std::optional<PrecisionLoss> worst_loss_of(const std::vector<StageValue>& values) {
  std::optional<PrecisionLoss> worst;
  for (const StageValue& value : values) {
    for (const WalkValue& component : value.components) {
      const auto& loss = component.loss;
      if (loss && (!worst || loss->bits_lost_here > worst->bits_lost_here)) worst = loss;
    }
  }
  return worst;
}

std::string equation_of(const StageValue& value, Precision precision) {
  std::string text = value.name;
  if (!value.formula.empty() && value.formula != value.name) text += " = " + value.formula;
  const std::string result = shown(value, precision);
  const bool has_numbers = !value.put_in.empty() && value.put_in != result && value.put_in != value.formula;
  if (has_numbers) text += " = " + value.put_in;
  return text + " = " + result;
}

}  // namespace rayproof::viz
