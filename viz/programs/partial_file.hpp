#pragma once
/// \file
/// A file that stands under its name only once it is whole.

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "case/files.hpp"

namespace rayproof::viz {

/// A file beside the one asked for, which takes its name in one step at the end, or goes away with this
/// object.
class PartialFile {
 public:
  /// Throws std::runtime_error with one sentence where the file can't be written.
  explicit PartialFile(const std::filesystem::path& asked)
      : asked_(asked), partial_(fmt::format("{}.{}.part", asked.string(), getpid())) {
    if (std::filesystem::is_directory(asked_) || !std::ofstream(partial_, std::ios::binary)) fail();
  }
  ~PartialFile() {
    std::error_code ignored;
    std::filesystem::remove(partial_, ignored);
  }
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  /// Where to write meanwhile.
  [[nodiscard]] std::string path() const { return partial_.string(); }

  void keep() {
    if (!put_in_place(partial_, asked_)) fail();
  }

 private:
  [[noreturn]] void fail() const {
    throw std::runtime_error(fmt::format("the file {} can't be written", asked_.string()));
  }

  std::filesystem::path asked_, partial_;
};

}  // namespace rayproof::viz
