#include <array>
#include <string_view>

#include "viz/trace/expression.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/trace/record.hpp"

namespace rayproof::viz {
namespace {

using Kind = Expression::Kind;

/// A number by its name, or else what it was computed from.
Formula operand(const Tape& tape, OperationId id) {
  if (id == unrecorded) return make(Kind::name, {}, "?");
  const Operation<Shadow>& o = tape.at(id);
  return o.name.empty() ? formula_of(tape, id) : named_formula(o.name, {o.value});
}

// Of three bytes each.
constexpr std::string_view low_signs = "₀₁₂₃₄₅₆₇₈₉ₓᵢⱼₖ";
constexpr std::string_view plain_signs = "0123456789xijk";

using Kind = Expression::Kind;

constexpr std::array<char, 3> axis_letters{'x', 'y', 'z'};

/// The names of the three components of one vector, as its name; null where they are no such three.
Formula merged_name(const std::vector<Formula>& components) {
  std::string vector;
  std::vector<double> values;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const std::string of_this = vector_of(components[i]->text, axis_letters.at(i));
    if (of_this.empty() || (i > 0 && of_this != vector)) return nullptr;
    vector = of_this;
    values.insert(values.end(), components[i]->values.begin(), components[i]->values.end());
  }
  return named_formula(vector, values);
}

/// The formulas as one, each name's components as the vector; null where they differ in more than the axis.
Formula merged(const std::vector<Formula>& components) {
  const Expression& first = *components[0];
  if (first.kind == Kind::name) {
    if (Formula vector = merged_name(components)) return vector;
  }
  for (const Formula& other : components) {
    const bool is_same = other->kind == first.kind && other->text == first.text &&
                         other->signs == first.signs && other->parts.size() == first.parts.size();
    if (!is_same) return nullptr;
  }
  if (first.kind == Kind::name) return components[0];
  Expression whole = first;
  for (std::size_t part = 0; part < first.parts.size(); ++part) {
    std::vector<Formula> parts;
    for (const Formula& component : components) parts.push_back(component->parts[part]);
    whole.parts[part] = merged(parts);
    if (whole.parts[part] == nullptr) return nullptr;
  }
  return std::make_shared<const Expression>(std::move(whole));
}

/// The same; null, too, where no name has an axis.
Formula common_vector(const std::vector<Formula>& components) {
  const Formula vector = merged(components);
  return vector != nullptr && text_of(vector) != text_of(components[0]) ? vector : nullptr;
}

/// The factor of a term of each component, beginning with that of the `first` component, so that its axes
/// are x, y and z; null where they aren't.
Formula factor(const std::vector<Formula>& components, std::size_t term, std::size_t side,
               std::size_t first) {
  std::vector<Formula> factors;
  for (std::size_t i = 0; i < 3; ++i) {
    const Formula& sum = components[(first + i) % 3];
    if (sum->kind != Kind::sum || sum->parts.size() != 2 || sum->signs != std::vector<std::string>{"", "−"})
      return nullptr;
    const Formula& product = sum->parts[term];
    if (product->kind != Kind::product) return nullptr;
    factors.push_back(product->parts[side]);
  }
  return common_vector(factors);
}

/// "a × b" of "a.y·b.z − a.z·b.y" and so on.
Formula cross_product(const std::vector<Formula>& components) {
  if (components.size() != 3) return nullptr;
  const Formula a = factor(components, 0, 0, 2), b = factor(components, 0, 1, 1);
  const Formula other_a = factor(components, 1, 0, 1), other_b = factor(components, 1, 1, 2);
  const bool is_cross =
      a != nullptr && b != nullptr && text_of(a) == text_of(other_a) && text_of(b) == text_of(other_b);
  return is_cross ? make(Kind::cross, {a, b}) : nullptr;
}

}  // namespace

Formula formula_of(const Tape& tape, OperationId id) {
  const Operation<Shadow>& o = tape.at(id);
  const auto at = [&](std::size_t i) { return operand(tape, o.operands[i]); };
  switch (o.op) {
    case Operator::constant:
      return o.name.empty() ? number_formula(rough(o.value, 17), {o.value})
                            : named_formula(o.name, {o.value});
    case Operator::negate:
      return with_term(nullptr, "−", at(0));
    case Operator::add:
      return dot_or(with_term(at(0), "+", at(1)));
    case Operator::subtract:
      return with_term(at(0), "−", at(1));
    case Operator::multiply:
      return make(Kind::product, {at(0), at(1)});
    case Operator::divide:
      return make(Kind::quotient, {at(0), at(1)});
    case Operator::square_root:
      return make(Kind::root, {at(0)});
    case Operator::fused_multiply_add:
      return make(Kind::call, {at(0), at(1), at(2)}, "fma");
    case Operator::absolute:
      return make(Kind::absolute, {at(0)});
    case Operator::copy_sign:
      return make(Kind::call, {at(0), at(1)}, "copysign");
    case Operator::exponent:
      return make(Kind::call, {at(0)}, "exponent");
    case Operator::scale_exponent:
      return make(Kind::product, {at(0), make(Kind::power, {number_formula("2"), at(1)})});
    case Operator::floor:
      return make(Kind::call, {at(0)}, "floor");
  }
  return nullptr;
}

NameParts parts_of_name(std::string name) {
  NameParts parts;
  const auto take_index = [&](std::size_t at) {
    if (at == std::string::npos || at == 0) return;
    parts.index = name.substr(at + 1) + parts.index;
    name.erase(at);
  };
  take_index(name.rfind('.'));
  take_index(name.find('_'));
  while (name.size() > 3) {
    const std::size_t sign = low_signs.find(name.substr(name.size() - 3));
    if (sign == std::string_view::npos) break;
    parts.index = plain_signs[sign / 3] + parts.index;
    name.erase(name.size() - 3);
  }
  parts.letters = name;
  return parts;
}

std::string vector_of(const std::string& name, char axis) {
  const bool is_component = name.size() > 2 && name[name.size() - 2] == '.' && name.back() == axis;
  return is_component ? name.substr(0, name.size() - 2) : "";
}

std::string without_axis(const std::string& name) {
  for (const char axis : {'x', 'y', 'z'}) {
    if (std::string vector = vector_of(name, axis); !vector.empty()) return vector;
  }
  return name;
}

Formula vector_formula(const std::vector<Formula>& components) {
  if (components.size() < 2) return nullptr;
  for (const Formula& component : components)
    if (component == nullptr) return nullptr;
  const Formula plain = common_vector(components);
  return plain != nullptr ? plain : cross_product(components);
}

Formula dot_or(const Formula& formula) {
  if (formula->kind != Kind::sum || formula->parts.size() != 3 ||
      formula->signs != std::vector<std::string>{"", "+", "+"})
    return formula;
  std::vector<Formula> vectors;
  for (std::size_t side = 0; side < 2; ++side) {
    std::vector<Formula> factors;
    for (const Formula& product : formula->parts) {
      // |n| of a vector's components would read as its length.
      if (product->kind != Kind::product || product->parts[side]->kind == Kind::absolute) return formula;
      factors.push_back(product->parts[side]);
    }
    vectors.push_back(common_vector(factors));
    if (vectors.back() == nullptr) return formula;
  }
  return make(Kind::dot, vectors);
}

}  // namespace rayproof::viz
