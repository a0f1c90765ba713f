#pragma once
/// \file
/// Progress on standard error: a line that changes on a terminal, a plain line now and then elsewhere.

#include <chrono>
#include <string>

#include "properties/engine.hpp"

namespace rayproof::check {

class ProgressLine {
 public:
  ProgressLine();

  /// Tells what is being done, how far it is and how long it will take, but not too often.
  void show(const Progress& progress);
  /// Takes the line away, so that other text can be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  bool is_terminal_;
  bool is_shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_{};
};

}  // namespace rayproof::check
