#pragma once
/// \file
/// What is timed: a method's pass over many problems that lie in memory as arrays.

#include <functional>
#include <rayproof/batch/instruction_set.hpp>
#include <string>
#include <vector>

#include "bench/figures/row.hpp"

namespace rayproof::report {

/// Answers the first `count` problems of its arrays.
struct Contender {
  std::string method;
  Arrangement arrangement = Arrangement::scalar;
  std::function<void(std::size_t count)> pass;
  InstructionSet set = InstructionSet::baseline;  ///< of a batch
};

/// Every method of the cases' topic in both arrangements, GLM and, where there are batches, the floor, over
/// problems made from the cases; batches by each of the instruction sets.
[[nodiscard]] std::vector<Contender> contenders(const std::string& topic, const std::vector<Case>& cases,
                                                Precision precision,
                                                const std::vector<InstructionSet>& sets = {
                                                    preferred_instruction_set()});

/// The nanoseconds a problem costs each contender, of each timed pass. All take turns, so that a disturbance
/// hits all alike; a contender for which `rays` problems take long is given fewer. `seconds` is about what
/// all together may take.
[[nodiscard]] std::vector<std::vector<double>> time_passes(const std::vector<Contender>& contenders,
                                                           std::size_t rays, double seconds);

/// Keeps the compiler from answering several problems at once where one at a time is to be timed.
inline void one_at_a_time() { asm volatile("" ::: "memory"); }

}  // namespace rayproof::report
