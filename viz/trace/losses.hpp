#pragma once
/// \file
/// What the operations of a tape lost: those of a step, and those of one number's own formula.

#include <optional>
#include <string>
#include <vector>

#include "viz/trace/tape.hpp"

namespace rayproof::viz {

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
