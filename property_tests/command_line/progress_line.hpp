#pragma once
/// \file
/// Progress on standard error: a line that changes on a terminal, a plain line now and then elsewhere.

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

namespace rayproof {

class ProgressLine {
 public:
  ProgressLine() = default;
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows what is being done, how far it is (from 0 to 1) and how long it will take, but not too often. Work
  /// that goes back to where less is done has begun anew.
  void show(double done, const std::string& what) {
    const Clock::time_point now = Clock::now();
    if (done < done_) start_ = now;
    done_ = done;
    if (now - last_ < (is_terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10'000)))
      return;
    last_ = now;
    const std::string line = fmt::format("{:3.0f} %  {}  {}", 100 * done, to_go(now), what);
    if (is_terminal_) {
      fmt::print(stderr, "\r\x1b[K{}", line.substr(0, 100));
      is_shown_ = true;
    } else {
      fmt::print(stderr, "{}\n", line);
    }
    std::fflush(stderr);
  }

  /// Takes the line away, so that other text can be printed.
  void clear() {
    if (is_shown_) fmt::print(stderr, "\r\x1b[K");
    is_shown_ = false;
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// "1:05 to go", minutes and seconds.
  [[nodiscard]] std::string to_go(Clock::time_point now) const {
    if (!(done_ > 0.01)) return "just begun";
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const auto left = std::llround(elapsed * (1 - done_) / done_);
    return fmt::format("{}:{:02} to go", left / 60, left % 60);
  }

  bool is_terminal_ = isatty(STDERR_FILENO) != 0;
  bool is_shown_ = false;
  double done_ = 0;
  Clock::time_point start_ = Clock::now();
  /// On a terminal the first line comes at once, elsewhere only where the work takes long.
  Clock::time_point last_ = is_terminal_ ? Clock::time_point{} : Clock::now();
};

}  // namespace rayproof
