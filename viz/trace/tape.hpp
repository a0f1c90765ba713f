#pragma once
/// \file
/// Reading the tape of a recorded kernel: formulas, and the operation that lost the most digits.

#include <optional>
#include <rayproof/arithmetics/recording.hpp>
#include <string>

#include "viz/trace/expression.hpp"
#include "viz/trace/shadow.hpp"
#include "viz/trace/walkthrough.hpp"

namespace rayproof::viz {

using Tape = Recording<Shadow>;

/// What the operation computes, in the names the kernel gave: "b·b − 4·a·c". Does not stop at its own name.
[[nodiscard]] Formula formula_of(const Tape& tape, OperationId id);

/// The operation that loses most on the path from the inputs to `result`, found by following, from the result
/// backwards, the operand through which the most error came. Nothing where no operation on that path loses
/// `least_bits` bits or more.
[[nodiscard]] std::optional<PrecisionLoss> find_decisive_loss(const Tape& tape, OperationId result,
                                                              double least_bits);

/// Names the loss of one operation.
[[nodiscard]] PrecisionLoss describe_loss(const Tape& tape, OperationId id);

}  // namespace rayproof::viz
