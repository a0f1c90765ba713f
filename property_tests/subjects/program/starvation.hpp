#pragma once
/// \file
/// Whether a process is silent because it is not given the processor.

#include <sys/types.h>

#include <chrono>

namespace rayproof::program {

/// Watches a process group for as long as it is silent. On a busy machine a program may be ready to answer
/// and not get to it: that is no fault of its own.
class Starvation {
 public:
  /// `group` is the process group's number.
  explicit Starvation(pid_t group) : group_(group) {}

  /// Whether some process of the group is ready to run and they have had less than half of the processor
  /// since the last call; of the first call, whether one is ready.
  [[nodiscard]] bool goes_on();
  /// Whether no process of the group is ready to run or waits for a disk, and they have not run since the
  /// last call of this.
  [[nodiscard]] bool is_idle();

 private:
  using Clock = std::chrono::steady_clock;

  pid_t group_;
  bool was_asked_ = false;
  Clock::time_point last_{};
  double used_ = 0;        ///< seconds of the processor, all processes of the group together
  double used_idle_ = -1;  ///< the same when it was last asked whether it is idle
};

}  // namespace rayproof::program
