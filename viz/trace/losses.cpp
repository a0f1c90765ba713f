#include "viz/trace/record.hpp"

#include <fmt/format.h>

#include <cctype>

namespace rayproof::viz {

std::vector<OperationId> operations_of_step(const Tape& tape, std::ptrdiff_t step) {
  std::vector<OperationId> operations;
  for (std::size_t i = 0; i < tape.operations.size(); ++i) {
    if (tape.operations[i].step == step) operations.push_back(static_cast<OperationId>(i));
  }
  return operations;
}

std::vector<OperationId> operations_of_value(const Tape& tape, OperationId value) {
  std::vector<OperationId> operations{value};
  for (std::size_t next = 0; next < operations.size(); ++next) {
    for (const OperationId id : tape.at(operations[next]).operands) {
      const bool is_part =
          id != unrecorded && tape.at(id).name.empty() && tape.at(id).step == tape.at(value).step;
      if (is_part) operations.push_back(id);
    }
  }
  return operations;
}

namespace {

/// A product's own rounding error, computed on purpose: in real numbers it is 0, so that it has no digits to
/// lose.
bool is_error_term(const Operation<Shadow>& operation) {
  return operation.op == Operator::fused_multiply_add && operation.exact == 0;
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

}  // namespace rayproof::viz
