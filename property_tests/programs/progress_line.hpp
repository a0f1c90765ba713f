#pragma once
/// \file
/// Progress on standard error: a line that changes on a terminal, a plain line now and then elsewhere.

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>

namespace rayproof {

class ProgressLine {
 public:
  /// Tells what is being done and how far it is, but not too often.
  void show(double done, const std::string& what) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < (is_terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10'000)))
      return;
    last_ = now;
    fmt::print(stderr, "{}{:3.0f} %  {}{}", is_terminal_ ? "\r\x1b[K" : "", 100 * done, what,
               is_terminal_ ? "" : "\n");
    std::fflush(stderr);
  }

  /// Takes the line away, so that other text can be printed.
  void clear() const {
    if (is_terminal_) fmt::print(stderr, "\r\x1b[K");
  }

 private:
  bool is_terminal_ = isatty(STDERR_FILENO) != 0;
  /// On a terminal the first line comes at once, elsewhere only where the work takes long.
  std::chrono::steady_clock::time_point last_ =
      is_terminal_ ? std::chrono::steady_clock::time_point{} : std::chrono::steady_clock::now();
};

}  // namespace rayproof
