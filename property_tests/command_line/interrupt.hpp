#pragma once
/// \file
/// Ctrl-C, and SIGTERM, by which timeout(1) and batch systems end a program: one that has something to keep
/// ends by itself, with what it has.

#include <atomic>
#include <csignal>

namespace rayproof {

/// Set by SIGINT or SIGTERM once `keep_on_interrupt` was called.
inline std::atomic<bool> is_interrupted{false};

/// From now on both set `is_interrupted` and end nothing. Further ones change nothing: some programs send
/// them twice (timeout(1) to the process and to its group), and what was found must not be lost to the
/// second. SIGQUIT (Ctrl-\) ends the program at once, as usual.
inline void keep_on_interrupt() {
  struct sigaction action = {};
  action.sa_handler = [](int) { is_interrupted = true; };
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

}  // namespace rayproof
