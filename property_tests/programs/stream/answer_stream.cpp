#include "programs/stream/answer_stream.hpp"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "case/reader.hpp"
#include "case/writer.hpp"

namespace rayproof {
namespace {

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
  [[nodiscard]] std::optional<LineBlock> next() {
    for (;;) {
      const std::size_t before = pending_.size();
      if (!read_more()) return before == 0 ? std::nullopt : std::optional(cut(before));
      const std::size_t newline = std::string_view(pending_).substr(before).rfind('\n');
      if (newline != std::string_view::npos) return cut(before + newline + 1);
    }
  }

 private:
  /// Appends what a single read gives to `pending_`; false at the end of the stream.
  bool read_more() {
    // Large enough to make the hand-over to a worker cheap, small enough to spread a short file over all
    // workers.
    constexpr std::size_t bytes_per_read = std::size_t{1} << 17;
    const std::size_t before = pending_.size();
    pending_.resize(before + bytes_per_read);
    ssize_t count = 0;
    do {
      count = ::read(file_, pending_.data() + before, bytes_per_read);
    } while (count < 0 && errno == EINTR);
    pending_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count < 0) throw std::system_error(errno, std::generic_category(), "the input cannot be read");
    return count > 0;
  }

  /// Takes the block of the first `size` bytes.
  LineBlock cut(std::size_t size) {
    LineBlock block{pending_.substr(0, size), line_};
    pending_.erase(0, size);
    line_ += static_cast<std::size_t>(std::ranges::count(block.text, '\n'));
    return block;
  }

  int file_;
  std::size_t line_ = 1;
  std::string pending_{};
};

/// The answer to a line. Throws a RefusedCase.
std::string answer_line(std::string_view line, const AnswerFunction& answer) {
  const Case one = read_case(line);
  try {
    return write_answer(one, answer(one));
  } catch (const Refusal& why) {
    throw RefusedCase(why, one.id);
  }
}

/// The answers to a block's lines, each with its newline.
std::string answer_block(const LineBlock& block, const AnswerFunction& answer,
                         std::atomic<std::size_t>& refused) {
  std::string answers;
  answers.reserve(block.text.size());
  std::size_t number = block.first_line;
  for (std::string_view rest = block.text; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    try {
      answers += answer_line(rest.substr(0, end), answer);
    } catch (const RefusedCase& why) {
      answers += write_refusal(why, number);
      ++refused;
    }
    answers += '\n';
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return answers;
}

void write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(file, text.data(), text.size());
    if (count < 0 && errno != EINTR) {
      throw std::system_error(errno, std::generic_category(), "the output cannot be written");
    }
    text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  }
}

}  // namespace

std::size_t answer_stream(int input, int output, const AnswerFunction& answer) {
  using tbb::filter_mode;
  constexpr std::size_t blocks_per_thread = 4;  // bounds the memory
  std::atomic<std::size_t> refused = 0;
  LineBlockReader reader(input);
  const auto read = [&reader](tbb::flow_control& flow) {
    auto block = reader.next();
    if (!block) flow.stop();
    return std::move(block).value_or(LineBlock());
  };
  const auto work = [&](const LineBlock& block) { return answer_block(block, answer, refused); };
  const auto write = [output](const std::string& text) { write_all(output, text); };
  // The thread that has read a block answers it and writes; another one waits for the next line meanwhile.
  tbb::parallel_pipeline(
      blocks_per_thread * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()),
      tbb::make_filter<void, LineBlock>(filter_mode::serial_in_order, read) &
          tbb::make_filter<LineBlock, std::string>(filter_mode::parallel, work) &
          tbb::make_filter<std::string, void>(filter_mode::serial_in_order, write));
  return refused;
}

}  // namespace rayproof
