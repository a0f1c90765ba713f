#pragma once
/// \file
/// A stream of lines, taken a block of whole lines at a time.

#include <cstddef>
#include <optional>
#include <string>

namespace rayproof {

/// One or more whole lines. Each ends in a newline, but for the last line of a stream.
struct LineBlock {
  std::string text;
  std::size_t first_line = 1;  ///< its number in the stream, from 1
};

/// Reads a file descriptor. Large blocks from a file; from a pipe whatever lines have arrived, so that a
/// partner who waits for the answer to each line gets it.
class LineBlockReader {
 public:
  explicit LineBlockReader(int file) : file_(file) {}

  /// The next block; nothing at the end. Throws std::system_error where reading fails.
  [[nodiscard]] std::optional<LineBlock> next();

 private:
  /// Appends what a single read gives to `pending_`; false at the end of the stream.
  bool read_more();
  LineBlock cut(std::size_t size);

  int file_;
  std::size_t line_ = 1;
  std::string pending_{};
};

}  // namespace rayproof
