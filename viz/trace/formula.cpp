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

}  // namespace rayproof::viz
