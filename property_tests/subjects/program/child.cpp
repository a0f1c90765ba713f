#include "subjects/program/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace rayproof::program {
namespace {

using std::chrono::milliseconds;

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

void close_once(int& file) {
  if (file >= 0) ::close(file);
  file = -1;
}

/// The two ends of a pipe, to read and to write, closed in every program that is started later; and here,
/// too, but for the one that is taken.
struct PipeEnds {
  std::array<int, 2> ends{};

  PipeEnds() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("a pipe cannot be made");
  }
  PipeEnds(const PipeEnds&) = delete;
  PipeEnds& operator=(const PipeEnds&) = delete;
  ~PipeEnds() {
    for (int& end : ends) close_once(end);
  }
  [[nodiscard]] int take(std::size_t which) { return std::exchange(ends.at(which), -1); }
};

/// What the end of a program's standard error is kept of; and how much of it is read at once, so that one
/// that writes much need not wait for whoever reads.
constexpr std::size_t kept_of_errors = 4096;
constexpr std::size_t block_of_errors = 1U << 20U;

void never_block(int file) { ::fcntl(file, F_SETFL, ::fcntl(file, F_GETFL) | O_NONBLOCK); }

/// A plain command takes the shell's place, so that its end and that of its output are seen as they are.
std::string in_place_of_shell(const std::string& command) {
  const bool is_plain = command.find_first_of(";|&()<>$`!{}\n\\") == std::string::npos;
  const std::size_t word_end = std::min(command.find(' '), command.size());
  const bool sets_variable = command.substr(0, word_end).find('=') != std::string::npos;
  return is_plain && !sets_variable ? "exec " + command : command;
}

/// What the new process does between fork and exec: only what is allowed there.
[[noreturn]] void become(const char* command, int input, int output, int errors) {
  ::setpgid(0, 0);
  ::signal(SIGPIPE, SIG_DFL);
  ::signal(SIGINT, SIG_DFL);
  ::dup2(input, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(errors, STDERR_FILENO);
  ::execl("/bin/sh", "sh", "-c", command, static_cast<char*>(nullptr));
  ::_exit(127);
}

}  // namespace

Child::Child(const std::string& command) {
  static const auto ignore = std::signal(SIGPIPE, SIG_IGN);  // a child that has ended is no reason to end
  (void)ignore;
  PipeEnds input, output, errors;
  const std::string line = in_place_of_shell(command);
  id_ = ::fork();
  if (id_ < 0) fail("no process can be started");
  if (id_ == 0) become(line.c_str(), input.ends[0], output.ends[1], errors.ends[1]);
  ::setpgid(id_, id_);  // whoever is first
  input_ = input.take(1);
  output_ = output.take(0);
  errors_ = errors.take(0);
  for (const int file : {input_, output_, errors_}) never_block(file);
  (void)::fcntl(errors_, F_SETPIPE_SZ, static_cast<int>(block_of_errors));  // where the system has room
}

// Until it is waited for here, its number is no other group's.
Child::~Child() {
  ::kill(-id_, SIGKILL);
  close_once(input_);
  close_once(output_);
  close_once(errors_);
  ::waitpid(id_, nullptr, 0);
}

void Child::exchange(std::string& unsent, std::string& received, milliseconds limit) {
  std::array<pollfd, 3> files{{{output_, POLLIN, 0}, {errors_, POLLIN, 0}, {input_, POLLOUT, 0}}};
  if (unsent.empty()) files[2].fd = -1;
  if (::poll(files.data(), files.size(), static_cast<int>(limit.count())) < 0 && errno != EINTR)
    fail("the program cannot be waited for");
  if (files[0].revents != 0 && !read_some(output_, received)) close_once(output_);
  if (files[1].revents != 0 && !read_errors()) close_once(errors_);
  if (files[2].revents != 0) write_some(unsent);
}

void Child::write_some(std::string& unsent) {
  const ssize_t count = ::write(input_, unsent.data(), unsent.size());
  if (count > 0) unsent.erase(0, static_cast<std::size_t>(count));
  if (count >= 0 || errno == EAGAIN || errno == EINTR) return;
  unsent.clear();  // it reads no more; whether it answers is another matter
  close_once(input_);
}

bool Child::read_some(int file, std::string& into) {
  constexpr std::size_t block = 1U << 16U;
  const std::size_t before = into.size();
  into.resize(before + block);
  const ssize_t count = ::read(file, into.data() + before, block);
  into.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

bool Child::read_errors() {
  thread_local std::vector<char> block(block_of_errors);
  const ssize_t count = ::read(errors_, block.data(), block.size());
  const auto size = static_cast<std::size_t>(std::max<ssize_t>(count, 0));
  error_bytes_ += size;
  const std::size_t end = std::min(size, kept_of_errors);
  error_text_.append(block.data() + (size - end), end);
  if (error_text_.size() > 2 * kept_of_errors) error_text_.erase(0, error_text_.size() - kept_of_errors);
  return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

void Child::close_input() { close_once(input_); }

bool Child::has_ended(milliseconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!end_) {
    siginfo_t seen{};
    const bool is_seen = ::waitid(P_PID, static_cast<id_t>(id_), &seen, WEXITED | WNOHANG | WNOWAIT) == 0 &&
                         seen.si_pid == id_;
    if (is_seen) end_ = {.is_signal = seen.si_code != CLD_EXITED, .number = seen.si_status};
    if (is_seen || std::chrono::steady_clock::now() > end) break;
    std::this_thread::sleep_for(milliseconds(1));
  }
  return end_.has_value();
}

std::string Child::how_it_ended() {
  if (!has_ended(milliseconds(200))) return "";
  const bool is_shell_report = !end_->is_signal && end_->number > 128 && end_->number < 128 + 65;
  if (!end_->is_signal && !is_shell_report) return fmt::format("ended with exit status {}", end_->number);
  const int signal = is_shell_report ? end_->number - 128 : end_->number;
  return fmt::format("was ended by signal {} ({})", signal, ::strsignal(signal));
}

std::optional<int> Child::exit_status() const {
  if (!end_ || end_->is_signal) return std::nullopt;
  return end_->number;
}

std::string Child::last_words() {
  while (errors_ >= 0) {
    const std::uint64_t before = error_bytes_;
    if (!read_errors()) close_once(errors_);
    if (error_bytes_ == before) break;
  }
  constexpr std::size_t longest = 400;
  std::string text = error_text_.substr(error_text_.size() - std::min(error_text_.size(), longest));
  for (char& c : text) c = c == '\n' ? '|' : c < ' ' || c > '~' ? '?' : c;
  while (!text.empty() && (text.back() == '|' || text.back() == ' ')) text.pop_back();
  return text;
}

}  // namespace rayproof::program
