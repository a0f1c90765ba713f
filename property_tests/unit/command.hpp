#pragma once
/// \file
/// Running a program as somebody outside would, in a shell.

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace rayproof::test {

/// How a command ended, and what it said.
struct Ended {
  int status = -1;     ///< the exit status, or 128 + the signal that ended it
  std::string output;  ///< standard output and standard error
};

/// A command that runs beside the test.
class Running {
 public:
  explicit Running(const std::string& command) : pipe_(::popen(("{ " + command + "; } 2>&1").c_str(), "r")) {}

  [[nodiscard]] Ended wait() {
    Ended ended;
    std::array<char, 4096> block{};
    for (std::size_t got = 0; (got = std::fread(block.data(), 1, block.size(), pipe_)) > 0;)
      ended.output.append(block.data(), got);
    const int status = ::pclose(pipe_);
    ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return ended;
  }

 private:
  FILE* pipe_;
};

[[nodiscard]] inline Ended run(const std::string& command) { return Running(command).wait(); }

}  // namespace rayproof::test
