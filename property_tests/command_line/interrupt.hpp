#pragma once
/// \file
/// Ctrl-C: a program that has something to keep ends by itself, with what it has.

#include <atomic>
#include <csignal>

namespace rayproof {

/// Set by SIGINT once `keep_on_interrupt` was called.
inline std::atomic<bool> is_interrupted{false};

/// From now on SIGINT sets `is_interrupted` and ends nothing. Further ones change nothing: some programs send
/// it twice (timeout(1) to the process and to its group), and what was found must not be lost to the second.
/// SIGQUIT (Ctrl-\) and SIGTERM end the program at once, as usual.
inline void keep_on_interrupt() {
  struct sigaction action = {};
  action.sa_handler = [](int) { is_interrupted = true; };
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
}

}  // namespace rayproof
