#pragma once
/// \file
/// The instruction sets that the batch kernels are built for, and which of them this machine has.

#include <string_view>
#include <vector>

namespace rayproof {

/// In ascending order of width. `baseline` is what the whole library is compiled for; the others are built on
/// x86-64.
enum class InstructionSet { baseline, avx2, avx512 };

/// "baseline", "avx2" or "avx512".
[[nodiscard]] std::string_view name_of(InstructionSet set);

/// The sets that are built and that this machine has, ascending. Throws std::runtime_error if there are none.
[[nodiscard]] const std::vector<InstructionSet>& available_instruction_sets();

/// The widest available one, or the one that the environment variable RAYPROOF_ISA names. Throws
/// std::runtime_error where it names one that is not available.
[[nodiscard]] InstructionSet preferred_instruction_set();

}  // namespace rayproof
