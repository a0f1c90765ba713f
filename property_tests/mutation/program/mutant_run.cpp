#include "mutation/program/mutant_run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <string_view>

namespace rayproof::mutation {

namespace {

constexpr int most_microseconds = 500'000;        ///< of one case; the slowest sound one takes a tenth of it
constexpr rlim_t most_memory = rlim_t{8} << 30U;  ///< of a process, that of its parent included

/// What the process of a mutant sends to its parent.
struct Message {
  std::size_t input = 0;
  std::size_t property = 0;  ///< an index into properties(), 1 more than it; 0: none is broken
};

void start_watch() {
  const itimerval watch{{0, 0}, {0, most_microseconds}};
  setitimer(ITIMER_PROF, &watch, nullptr);  // whoever doesn't wind it up again in time is ended by SIGPROF
}

/// What the child does. Never returns.
[[noreturn]] void run_in_child(const Target& target, const std::vector<Input>& inputs, const Notes& notes,
                               int number, int out) {
  const Note& note = notes.of[static_cast<std::size_t>(number)];
  const rlimit memory{most_memory, most_memory}, no_dump{0, 0};
  setrlimit(RLIMIT_AS, &memory);
  setrlimit(RLIMIT_CORE, &no_dump);
  target.state.chosen = number;
  Message message;
  for (; message.input < inputs.size() && message.property == 0; ++message.input) {
    if (!note.differs[message.input]) continue;
    start_watch();
    if (repeats(target.subject, notes.transcripts[message.input])) continue;
    start_watch();
    if (const Property* broken =
            broken_by(target.subject, inputs[message.input], notes.known[message.input])) {
      message.property = static_cast<std::size_t>(broken - properties().data()) + 1;
      break;
    }
  }
  const bool is_sent = ::write(out, &message, sizeof message) == static_cast<ssize_t>(sizeof message);
  _exit(is_sent ? 0 : 3);
}

}  // namespace

MutantResult try_mutant(const Target& target, const std::vector<Input>& inputs, const Notes& notes,
                        int number) {
  const Note& note = notes.of[static_cast<std::size_t>(number)];
  if (std::ranges::find(note.differs, true) == note.differs.end()) return {};
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe to a process of its own");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process of its own");
  if (child == 0) {
    try {
      run_in_child(target, inputs, notes, number, ends[1]);
    } catch (...) {
      _exit(4);
    }
  }
  close(ends[1]);
  Message message;
  const bool is_heard = ::read(ends[0], &message, sizeof message) == static_cast<ssize_t>(sizeof message);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (is_heard && message.property == 0) return {};
  if (is_heard) return {std::string(properties()[message.property - 1].name), message.input};
  return {WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF ? "hang" : "crash", inputs.size()};
}

std::string as_json(int number, const Notes& notes, const MutantResult& result,
                    const std::vector<Input>& inputs) {
  const Note& note = notes.of[static_cast<std::size_t>(number)];
  std::string text =
      fmt::format("{{\"number\": {}, \"reached\": {}, \"met\": {}, \"differs\": {}, \"ended\": \"{}\"",
                  number, note.is_reached, note.is_met, std::ranges::count(note.differs, true), result.ended);
  if (result.input < inputs.size() && !result.ended.empty()) {
    const Input& input = inputs[result.input];
    text += fmt::format(", \"family\": \"{}\", \"precision\": \"{}\", \"case\": {}", input.family,
                        input.one.precision == Precision::float32 ? "float32" : "float64", input.k);
    if (input.family == std::string_view("corpus")) text += fmt::format(", \"place\": {}", result.input);
  }
  return text + "}";
}

}  // namespace rayproof::mutation
