#pragma once
/// \file
/// Lines in, lines out: the loop of a program on trial.

#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>

namespace rayproof::answering {

/// Writes all of `text`, or throws std::system_error.
inline void write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category(), "write");
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// Calls `answer(line, out)` for each line of `input` until it is closed, and writes what that appends to
/// `out`. Every line that can be read is answered before the loop waits for more, so whoever sends one case
/// at a time and whoever sends thousands ahead are both served; neither waits for the other.
void answer_lines(int input, int output, auto&& answer) {
  std::string pending, out, chunk(std::size_t{1} << 16, '\0');
  const auto answer_if_written = [&](std::string_view line) {
    if (line.find_first_not_of(" \t\r") != std::string_view::npos) answer(line, out);
  };
  for (;;) {
    const ssize_t got = ::read(input, chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw std::system_error(errno, std::generic_category(), "read");
    const std::size_t seen = pending.size();  // no newline is in it
    pending.append(chunk.data(), static_cast<std::size_t>(got));
    std::size_t start = 0;
    for (std::size_t end = pending.find('\n', seen); end != std::string::npos;
         end = pending.find('\n', start)) {
      answer_if_written(std::string_view(pending).substr(start, end - start));
      start = end + 1;
    }
    pending.erase(0, start);
    if (got == 0) answer_if_written(pending);  // a last line without its newline
    write_all(output, out);
    out.clear();
    if (got == 0) return;
  }
}

}  // namespace rayproof::answering
