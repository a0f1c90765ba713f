#include "viz/losses.hpp"

#include <fmt/format.h>

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

std::optional<Death> worst_loss_of(const Tape& tape, const std::vector<OperationId>& operations) {
  OperationId worst = unrecorded;
  for (const OperationId id : operations) {
    if (is_error_term(tape.at(id))) continue;
    if (worst == unrecorded || tape.at(id).bits_lost_here > tape.at(worst).bits_lost_here) worst = id;
  }
  if (worst == unrecorded || tape.at(worst).bits_lost_here < noteworthy) return std::nullopt;
  return describe_loss(tape, worst);
}

std::string in_words(const Death& loss) {
  return fmt::format("the {} {} {} {:.0f} of {} bits", loss.kind, loss.formula, loss.effect,
                     loss.bits_lost_here, loss.digits);
}

std::string loss_sentence(const std::optional<Death>& loss) {
  return loss ? "T" + in_words(*loss).substr(1) + "." : "No digits of note are lost.";
}

}  // namespace rayproof::viz
