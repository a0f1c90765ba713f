#include "viz/trace/numbers.hpp"
#include "viz/trace/tape.hpp"

namespace rayproof::viz {
namespace {

using Kind = Expression::Kind;

/// A number by its name, or else what it was computed from.
Formula operand(const Tape& tape, OperationId id) {
  if (id == unrecorded) return make(Kind::name, {}, "?");
  const Operation<Shadow>& o = tape.at(id);
  return o.name.empty() ? formula_of(tape, id) : named_formula(o.name, {o.value});
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

}  // namespace rayproof::viz
