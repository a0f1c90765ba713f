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

/// Every method of the cases' topic in both arrangements and, where there are batches, the floor, over
/// problems made from the cases; batches by each of the instruction sets.
[[nodiscard]] std::vector<Contender> contenders(const std::string& topic, const std::vector<Case>& cases,
                                                Precision precision,
                                                const std::vector<InstructionSet>& sets = {
                                                    preferred_instruction_set()});

/// Seconds that this thread has run: the turns that other programs take on the processor don't count.
[[nodiscard]] double thread_seconds();
/// Seconds that have passed: what counts where threads share the work.
[[nodiscard]] double wall_seconds();

/// The nanoseconds a problem costs each contender, of each timed pass. All take turns, so that a disturbance
/// hits all alike; a contender for which `rays` problems take long is given fewer. `seconds` is about what
/// all together may take, by this clock.
[[nodiscard]] std::vector<std::vector<double>> time_passes(const std::vector<Contender>& contenders,
                                                           std::size_t rays, double seconds,
                                                           double (*now)() = thread_seconds);

/// The same as rows, which are otherwise as the pattern.
[[nodiscard]] std::vector<BenchRow> timed_rows(const std::vector<Contender>& contenders,
                                               const BenchRow& pattern, std::size_t rays, double seconds,
                                               double (*now)() = thread_seconds);

/// Keeps the compiler from answering several problems at once where one at a time is to be timed.
inline void one_at_a_time() { asm volatile("" ::: "memory"); }

}  // namespace rayproof::report
