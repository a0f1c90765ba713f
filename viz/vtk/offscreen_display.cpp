#include "viz/vtk/offscreen_display.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vtkRenderWindow.h>
#include <vtkXRenderWindowInteractor.h>

#include <array>
#include <cstdlib>
#include <string>

namespace rayproof::viz {
namespace {

constexpr int answer_within_ms = 10'000;
constexpr int end_within_ms = 2'000;

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

/// Ends the server in good order, or, where it does not heed that in time, at once. Its exit status as
/// waitpid has it.
int end_server(pid_t server) {
  int status = 0;
  kill(server, SIGTERM);
  for (int waited = 0; waited < end_within_ms; waited += 10) {
    if (waitpid(server, &status, WNOHANG) != 0) return status;
    poll(nullptr, 0, 10);
  }
  kill(server, SIGKILL);
  waitpid(server, &status, 0);
  return status;
}

struct Server {
  pid_t process = -1;
  std::string display{};  ///< its number; empty where the server did not start
  bool is_missing = false;
};

Server start_server(const char* screen) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw NoDisplay("no pipe could be opened to start Xvfb");
  const std::string answer_text = std::to_string(ends[1]);
  const pid_t parent = getpid();
  Server server;
  server.process = fork();
  if (server.process == 0) become_server(ends[1], answer_text.c_str(), screen, parent);
  close(ends[1]);
  if (server.process > 0) server.display = read_number(ends[0]);
  close(ends[0]);
  if (server.process > 0 && server.display.empty()) {
    const int status = end_server(server.process);
    server.is_missing = WIFEXITED(status) && WEXITSTATUS(status) == 127;
  }
  return server;
}

Display* display_of(vtkRenderWindowInteractor& interactor) {
  return static_cast<Display*>(interactor.GetRenderWindow()->GetGenericDisplayId());
}

}  // namespace

OffscreenDisplay::OffscreenDisplay(const char* screen) {
  if (const char* const before = std::getenv("DISPLAY")) display_before_ = before;
  // Of many servers that look for a free number at the same time, one now and then finds none.
  constexpr int attempts = 3;
  Server server;
  for (int attempt = 0; attempt < attempts && server.display.empty() && !server.is_missing; ++attempt)
    server = start_server(screen);
  if (server.is_missing)
    throw NoDisplay("a PNG needs the program Xvfb, which was not found (Debian package xvfb)");
  if (server.display.empty())
    throw NoDisplay("the virtual display Xvfb did not start, so no PNG can be drawn");
  server_ = server.process;
  setenv("DISPLAY", (":" + server.display).c_str(), 1);
}

OffscreenDisplay::~OffscreenDisplay() {
  if (display_before_) {
    setenv("DISPLAY", display_before_->c_str(), 1);
  } else {
    unsetenv("DISPLAY");
  }
  (void)end_server(server_);
}

UserDisplay::UserDisplay() {
  const char* const name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0') {
    throw NoDisplay("a window needs a display, and DISPLAY is not set; without --window none is needed");
  }
  Display* const display = XOpenDisplay(nullptr);
  if (display == nullptr) {
    throw NoDisplay(std::string("the display ") + name +
                    " of DISPLAY can't be opened; without --window none is needed");
  }
  int ignored = 0;
  if (XQueryExtension(display, "GLX", &ignored, &ignored, &ignored) == 0) {
    XCloseDisplay(display);
    throw NoDisplay(std::string("the display ") + name +
                    " can't show OpenGL (it lacks GLX); without --window none is needed");
  }
  connection_ = display;
}

UserDisplay::~UserDisplay() { XCloseDisplay(static_cast<Display*>(connection_)); }

void dispatch_events(vtkRenderWindowInteractor& interactor) {
  Display* const display = display_of(interactor);
  auto* const x = vtkXRenderWindowInteractor::SafeDownCast(&interactor);
  while (XPending(display) > 0) {
    XEvent event;
    XNextEvent(display, &event);
    x->DispatchEvent(&event);
  }
}

bool wait_for_events(vtkRenderWindowInteractor& interactor, int milliseconds) {
  Display* const display = display_of(interactor);
  if (XPending(display) > 0) return true;
  pollfd connection{ConnectionNumber(display), POLLIN, 0};
  return poll(&connection, 1, milliseconds) > 0;
}

}  // namespace rayproof::viz
