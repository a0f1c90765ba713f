#include "programs/stream/line_blocks.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace rayproof {
namespace {

/// Large enough to make the hand-over to a worker cheap, small enough to spread a short file over all
/// workers.
constexpr std::size_t bytes_per_read = std::size_t{1} << 17;

}  // namespace

std::optional<LineBlock> LineBlockReader::next() {
  for (;;) {
    const std::size_t before = pending_.size();
    if (!read_more()) {
      if (pending_.empty()) return std::nullopt;
      return cut(pending_.size());
    }
    const std::size_t newline = std::string_view(pending_).substr(before).rfind('\n');
    if (newline != std::string_view::npos) return cut(before + newline + 1);
  }
}

bool LineBlockReader::read_more() {
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

LineBlock LineBlockReader::cut(std::size_t size) {
  std::string rest = pending_.substr(size);
  pending_.resize(size);
  LineBlock block{std::move(pending_), line_};
  pending_ = std::move(rest);
  line_ += static_cast<std::size_t>(std::count(block.text.begin(), block.text.end(), '\n'));
  return block;
}

}  // namespace rayproof
