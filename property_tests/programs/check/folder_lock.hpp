#pragma once
/// \file
/// Two runs that wrote into one folder would leave a mixture of both.

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <string>

namespace rayproof::check {

/// As long as one lives, no other program's can be had of the same folder. A file system without locks has
/// none.
class FolderLock {
 public:
  /// Throws std::runtime_error with one sentence where another program has it.
  explicit FolderLock(const std::string& folder) : folder_(::open(folder.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (::flock(folder_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    ::close(folder_);
    throw std::runtime_error("another check or campaign is running in " + folder);
  }
  ~FolderLock() { ::close(folder_); }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int folder_;
};

}  // namespace rayproof::check
