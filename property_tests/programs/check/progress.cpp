#include "programs/check/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace rayproof::check {

namespace {

/// "1:05", minutes and seconds.
std::string as_clock(double seconds) {
  const auto whole = std::llround(seconds);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

ProgressLine::ProgressLine() : is_terminal_(isatty(STDERR_FILENO) != 0) {}

void ProgressLine::show(const Progress& progress) {
  const auto pause = is_terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10'000);
  const Clock::time_point now = Clock::now();
  if (now - last_ < pause) return;
  last_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const std::string left = progress.done > 0.01
                               ? as_clock(elapsed * (1 - progress.done) / progress.done) + " to go"
                               : "just begun";
  const std::string line = fmt::format("{:3.0f} %  {}  {}", 100 * progress.done, left, progress.what);
  if (is_terminal_) {
    fmt::print(stderr, "\r\x1b[K{}", line.substr(0, 100));
    is_shown_ = true;
  } else {
    fmt::print(stderr, "{}\n", line);
  }
  std::fflush(stderr);
}

void ProgressLine::clear() {
  if (is_shown_) fmt::print(stderr, "\r\x1b[K");
  is_shown_ = false;
}

}  // namespace rayproof::check
