#pragma once
/// \file
/// A bound on the memory that reading a file may take.

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>

namespace rayproof {

/// While it lives, the program can have only that many bytes of memory beside what it has already; whoever
/// asks for more gets std::bad_alloc. A reader that believes a damaged file's own counts would otherwise take
/// all that the machine has.
class MemoryBound {
 public:
  explicit MemoryBound(std::uintmax_t bytes) {
    std::uintmax_t pages = 0;
    is_set_ = getrlimit(RLIMIT_AS, &before_) == 0 && std::ifstream("/proc/self/statm") >> pages;
    if (!is_set_) return;
    const std::uintmax_t in_use = pages * static_cast<std::uintmax_t>(sysconf(_SC_PAGESIZE));
    const rlimit bounded{std::min<rlim_t>(before_.rlim_cur, in_use + bytes), before_.rlim_max};
    is_set_ = setrlimit(RLIMIT_AS, &bounded) == 0;
  }
  ~MemoryBound() {
    if (is_set_) setrlimit(RLIMIT_AS, &before_);
  }
  MemoryBound(const MemoryBound&) = delete;
  MemoryBound& operator=(const MemoryBound&) = delete;

 private:
  rlimit before_{};
  bool is_set_ = false;
};

/// As much as no reader of meshes needs for a file of that size: a vertex or a corner of a few bytes of text
/// becomes a few numbers, some of which are kept twice.
[[nodiscard]] inline std::uintmax_t memory_for_mesh(std::uintmax_t file_size) {
  return 64 * file_size + (std::uintmax_t{1} << 28);
}

}  // namespace rayproof
