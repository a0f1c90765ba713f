#include "viz/vtk/offscreen_display.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

namespace rayproof::viz {
namespace {

constexpr int answer_within_ms = 10'000;

/// In the child: becomes Xvfb, which writes its display's number to `answer`. Only async-signal-safe calls.
[[noreturn]] void become_server(int answer, const char* answer_text, const char* screen, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(1);  // the parent was gone before it could be watched
  // A group of its own: Ctrl-C reaches the drawing program, whose end then ends the server in good order.
  setpgid(0, 0);
  const int null = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (stream != answer) dup2(null, stream);
  }
  execlp("Xvfb", "Xvfb", "-displayfd", answer_text, "-screen", "0", screen, "-nolisten", "tcp", "-noreset",
         static_cast<char*>(nullptr));
  _exit(127);
}

/// The display's number, or nothing when the server ends or keeps silent.
std::string read_number(int answer) {
  std::string number;
  while (number.empty() || number.back() != '\n') {
    pollfd waiting{answer, POLLIN, 0};
    char digit = 0;
    if (poll(&waiting, 1, answer_within_ms) <= 0 || read(answer, &digit, 1) != 1) return {};
    number.push_back(digit);
  }
  number.pop_back();
  return number;
}

}  // namespace

OffscreenDisplay::OffscreenDisplay(const char* screen) {
  if (const char* const before = std::getenv("DISPLAY")) display_before_ = before;
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw NoDisplay("no pipe could be opened to start Xvfb");
  const std::string answer_text = std::to_string(ends[1]);
  const pid_t parent = getpid();
  server_ = fork();
  if (server_ == 0) become_server(ends[1], answer_text.c_str(), screen, parent);
  close(ends[1]);
  const std::string number = server_ > 0 ? read_number(ends[0]) : std::string();
  close(ends[0]);
  if (!number.empty()) {
    setenv("DISPLAY", (":" + number).c_str(), 1);
    return;
  }
  int status = 0;
  if (server_ > 0) {
    kill(server_, SIGTERM);
    waitpid(server_, &status, 0);
  }
  const bool is_missing = WIFEXITED(status) && WEXITSTATUS(status) == 127;
  throw NoDisplay(is_missing ? "a PNG needs the program Xvfb, which was not found (Debian package xvfb)"
                             : "the virtual display Xvfb did not start, so no PNG can be drawn");
}

OffscreenDisplay::~OffscreenDisplay() {
  if (display_before_) {
    setenv("DISPLAY", display_before_->c_str(), 1);
  } else {
    unsetenv("DISPLAY");
  }
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
}

}  // namespace rayproof::viz
