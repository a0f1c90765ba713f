#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "viz/trace/record.hpp"

namespace rayproof::viz {
namespace {

/// A product's own rounding error, computed on purpose: in real numbers it is 0, so that it has no digits to
/// lose.
bool is_error_term(const Operation<Shadow>& operation) {
  return operation.op == Operator::fused_multiply_add && operation.exact == 0;
}

constexpr double infinite = std::numeric_limits<double>::infinity();

double absolute_error(const Operation<Shadow>& o) {
  const double error = std::abs(static_cast<double>(Shadow(o.value) - o.exact));
  return std::isnan(error) ? infinite : error;
}
double relative_error(const Operation<Shadow>& o) {
  if (absolute_error(o) == 0) return 0;
  const double relative = std::abs(static_cast<double>((Shadow(o.value) - o.exact) / o.exact));
  return std::isnan(relative) ? infinite : relative;
}

/// How much of an operation's error came in through each operand; in one unit for all operands of the
/// operation.
double contribution(const Tape& tape, const Operation<Shadow>& o, std::size_t operand) {
  const Operation<Shadow>& from = tape.at(o.operands[operand]);
  switch (o.op) {
    case Operator::multiply:
    case Operator::divide:
      return relative_error(from);
    case Operator::fused_multiply_add: {
      if (operand == 2) return absolute_error(from);
      const Operation<Shadow>& other = tape.at(o.operands[1 - operand]);
      return absolute_error(from) * std::abs(other.value);
    }
    default:
      return absolute_error(from);
  }
}

OperationId worst_operand(const Tape& tape, const Operation<Shadow>& o) {
  OperationId worst = unrecorded;
  double most = 0;
  for (std::size_t i = 0; i < o.operands.size(); ++i) {
    if (o.operands[i] == unrecorded) continue;
    const double part = contribution(tape, o, i);
    if (part > most) {
      most = part;
      worst = o.operands[i];
    }
  }
  return worst;
}

double magnitude(const Tape& tape, OperationId id) {
  return id == unrecorded ? 0 : std::abs(tape.at(id).value);
}

bool cancels(const Tape& tape, const Operation<Shadow>& o) {
  const bool is_sum =
      o.op == Operator::add || o.op == Operator::subtract || o.op == Operator::fused_multiply_add;
  if (!is_sum) return false;
  const double largest = o.op == Operator::fused_multiply_add
                             ? magnitude(tape, o.operands[2])
                             : std::max(magnitude(tape, o.operands[0]), magnitude(tape, o.operands[1]));
  return std::max(std::abs(o.value), std::abs(static_cast<double>(o.exact))) < largest / 2;
}

std::string kind_of(Operator op, bool is_cancelling) {
  if (op == Operator::add) return is_cancelling ? "subtraction" : "addition";
  if (op == Operator::subtract) return "subtraction";
  if (op == Operator::multiply) return "multiplication";
  if (op == Operator::divide) return "division";
  if (op == Operator::square_root) return "square root";
  return op == Operator::fused_multiply_add ? "fused multiply-add" : "operation";
}

std::string effect_of(const Operation<Shadow>& o, bool is_cancelling) {
  if (!std::isfinite(o.value)) return std::isnan(o.value) ? "has no value and loses" : "overflows and loses";
  if (is_cancelling) return "cancels";
  const bool is_tiny =
      std::abs(o.value) < std::numeric_limits<float>::min() && o.value != static_cast<double>(o.exact);
  return is_tiny && (o.op == Operator::multiply || o.op == Operator::divide) ? "underflows and loses"
                                                                             : "loses";
}

PrecisionLoss describe_loss(const Tape& tape, OperationId id) {
  const Operation<Shadow>& o = tape.at(id);
  const bool is_cancelling = cancels(tape, o);
  PrecisionLoss loss;
  loss.step = o.step < 0 ? "the inputs" : tape.steps.at(static_cast<std::size_t>(o.step)).title;
  loss.kind = kind_of(o.op, is_cancelling);
  loss.effect = effect_of(o, is_cancelling);
  loss.formula = text_of(formula_of(tape, id));
  loss.name = o.name;
  loss.bits_lost_here = o.bits_lost_here;
  loss.bits_lost = o.bits_lost;
  loss.digits = o.digits;
  return loss;
}

}  // namespace

std::optional<PrecisionLoss> worst_loss_of(const Tape& tape, const std::vector<OperationId>& operations,
                                           double arrived) {
  OperationId worst = unrecorded;
  for (const OperationId id : operations) {
    if (is_error_term(tape.at(id)) || tape.at(id).bits_lost > arrived + 1) continue;
    if (worst == unrecorded || tape.at(id).bits_lost_here > tape.at(worst).bits_lost_here) worst = id;
  }
  if (worst == unrecorded || tape.at(worst).bits_lost_here < noteworthy) return std::nullopt;
  return describe_loss(tape, worst);
}

std::string in_words(const PrecisionLoss& loss) {
  constexpr std::size_t longest = 90;  // bytes: more of a formula nobody reads
  const bool is_vowel = loss.kind.find_first_of("aeiou") == 0;
  // Of "dot(n, p − o)" a reader would take the difference in it for what cancels.
  if (loss.effect == "cancels" && loss.formula.starts_with("dot(") &&
      loss.formula.find(')') + 1 == loss.formula.size())
    return fmt::format("the sum in {}, whose terms nearly cancel, loses {:.0f} of {} bits", loss.formula,
                       loss.bits_lost_here, loss.digits);
  const std::string what = loss.formula.size() <= longest
                               ? fmt::format("the {} {}", loss.kind, loss.formula)
                               : fmt::format("{} {}", is_vowel ? "an" : "a", loss.kind);
  if (loss.effect == "cancels")
    return fmt::format("{} loses {:.0f} of {} bits by cancellation", what, loss.bits_lost_here, loss.digits);
  return fmt::format("{} {} {:.0f} of {} bits", what, loss.effect, loss.bits_lost_here, loss.digits);
}

std::string loss_sentence(const std::optional<PrecisionLoss>& loss) {
  if (!loss) return "";
  std::string sentence = in_words(*loss) + ".";
  sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
  return sentence;
}

std::optional<PrecisionLoss> find_decisive_loss(const Tape& tape, OperationId result, double least_bits) {
  OperationId worst = unrecorded;
  for (OperationId id = result; id != unrecorded; id = worst_operand(tape, tape.at(id))) {
    const bool is_worse = worst == unrecorded || tape.at(id).bits_lost_here > tape.at(worst).bits_lost_here;
    if (is_worse) worst = id;
  }
  if (worst == unrecorded || tape.at(worst).bits_lost_here < least_bits) return std::nullopt;
  return describe_loss(tape, worst);
}

}  // namespace rayproof::viz
