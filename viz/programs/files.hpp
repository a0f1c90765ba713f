#pragma once
/// \file
/// Writing files for a user, who gets one sentence where it can't be done.

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "case/files.hpp"
#include "viz/programs/report_case.hpp"

namespace rayproof::viz {

/// Throws WrongCommand where the file can't be written.
inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text << std::flush;
  if (!out) throw WrongCommand("the file " + path.string() + " can't be written");
}

/// With all folders above it. Throws WrongCommand where it can't be made.
inline void make_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw WrongCommand("the folder " + folder.string() + " can't be made");
}

/// Where a page goes that no option names: beside the findings of the run, "draw-12.html" for finding 12;
/// empty for a case that is no finding of a run.
inline std::string page_beside_findings(const CaseOptions& options, const std::string& program) {
  if (!finding_number(options.text)) return "";
  const auto folder = std::filesystem::path(options.findings).parent_path();
  return (folder / fmt::format("{}-{}.html", program, options.text)).string();
}

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
