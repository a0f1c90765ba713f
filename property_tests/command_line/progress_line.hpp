#pragma once
/// \file
/// Progress on standard error: a line that changes on a terminal, a plain line now and then elsewhere.

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "case/print_to_stderr.hpp"

namespace rayproof {

/// How long the rest takes, "1:05 to go" in minutes and seconds, where the work went from the share `begun`
/// to the share `done` in that many seconds.
[[nodiscard]] inline std::string time_to_go(double begun, double done, double seconds) {
  const double whole = 1 - begun;
  if (!(done - begun > 0.01 * whole)) return "just begun";
  const auto left = std::llround(seconds * (1 - done) / (done - begun));
  return fmt::format("{}:{:02} to go", left / 60, left % 60);
}

class ProgressLine {
 public:
  ProgressLine() = default;
  /// Of work of which an earlier run has done that share.
  explicit ProgressLine(double begun) : begun_(begun), done_(begun) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows what is being done, how far it is (from 0 to 1) and how long it will take, but not too often. Work
  /// that goes back to where less is done has begun anew.
  void show(double done, const std::string& what) {
    const Clock::time_point now = Clock::now();
    if (done < done_) {
      start_ = now;
      begun_ = 0;
    }
    done_ = done;
    if (now - last_ < (is_terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10'000)))
      return;
    last_ = now;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const std::string line =
        fmt::format("{:3.0f} %  {}  {}", 100 * done, time_to_go(begun_, done, seconds), what);
    if (is_terminal_) {
      print_to_stderr("\r\x1b[K{}", cut_to_width(line));
      is_shown_ = true;
    } else {
      print_to_stderr("{}\n", line);
    }
    std::fflush(stderr);
  }

  /// Takes the line away, so that other text can be printed.
  void clear() {
    if (is_shown_) print_to_stderr("\r\x1b[K");
    is_shown_ = false;
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// One that can take a line away: a plain one is given plain lines.
  [[nodiscard]] static bool is_terminal() {
    const char* const kind = std::getenv("TERM");
    return isatty(STDERR_FILENO) != 0 && kind != nullptr && std::string_view(kind) != "dumb";
  }
  /// A line that is cut to the terminal's width: only one that is not broken can be taken away.
  [[nodiscard]] static std::string cut_to_width(const std::string& line) {
    winsize size{};
    const bool is_known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
    return line.substr(0, is_known ? std::min<std::size_t>(100, size.ws_col - 1U) : 100);
  }

  bool is_terminal_ = is_terminal();
  bool is_shown_ = false;
  double begun_ = 0;
  double done_ = 0;
  Clock::time_point start_ = Clock::now();
  /// On a terminal the first line comes at once, elsewhere only where the work takes long.
  Clock::time_point last_ = is_terminal_ ? Clock::time_point{} : Clock::now();
};

}  // namespace rayproof
