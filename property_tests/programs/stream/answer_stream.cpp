#include "programs/stream/answer_stream.hpp"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

#include "case/reader.hpp"
#include "case/writer.hpp"
#include "programs/stream/line_blocks.hpp"

namespace rayproof {
namespace {

/// The answer to a line. Throws a RefusedCase.
std::string answer_line(std::string_view line, const Answerer& answer) {
  const Case one = read_case(line);
  try {
    return write_answer(one, answer(one));
  } catch (const Refusal& why) {
    throw RefusedCase(why, one.id);
  }
}

/// The answers to a block's lines, each with its newline.
std::string answer_block(const LineBlock& block, const Answerer& answer, std::atomic<std::size_t>& refused) {
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

std::size_t answer_stream(int input, int output, const Answerer& answer) {
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
