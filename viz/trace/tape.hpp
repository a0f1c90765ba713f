#pragma once
/// \file
/// Reading the tape of a recorded kernel: formulas, what its operations lost, and which of them lost the
/// most.

#include <optional>
#include <rayproof/arithmetics/recording.hpp>
#include <string>
#include <vector>

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

/// Losses below this many bits are the everyday rounding of a few operations.
inline constexpr double noteworthy = 3;

/// The operations of a step, from 0.
[[nodiscard]] std::vector<OperationId> operations_of_step(const Tape& tape, std::ptrdiff_t step);

/// The operations of the number's own formula, itself first: from it back to numbers that have a name, to
/// inputs, and to earlier steps.
[[nodiscard]] std::vector<OperationId> operations_of_value(const Tape& tape, OperationId value);

/// The operation that loses most; nothing where none loses a noteworthy number of bits. `arrived` is what the
/// numbers lost that the operations arrive at: an operation whose result lost more than they did was made
/// good, as compensated sums and products do, and is not meant.
[[nodiscard]] std::optional<PrecisionLoss> worst_loss_of(const Tape& tape,
                                                         const std::vector<OperationId>& operations,
                                                         double arrived = infinity<double>);

}  // namespace rayproof::viz
