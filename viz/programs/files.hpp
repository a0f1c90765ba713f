#pragma once
/// \file
/// Writing files for a user, who gets one sentence where it can't be done.

#include <fmt/format.h>
#include <unistd.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "case/files.hpp"
#include "viz/programs/report_case.hpp"

namespace rayproof::viz {

/// Whether a device, a pipe or a folder stands there.
inline bool is_no_file(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
}

/// Throws WrongCommand where the name of an option's file is that of another kind, as a.jpg for a PNG.
inline void refuse_other_suffix(const std::string& option, const std::filesystem::path& file,
                                const std::string& suffix) {
  std::string given = file.extension().string();
  for (char& letter : given) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  if (!given.empty() && given != suffix && !is_no_file(file))
    throw WrongCommand(fmt::format("{} {} must end in {}", option, file.string(), suffix));
}

/// Where a page goes that no option names: beside the findings of the run, "draw-12.html" for finding 12;
/// empty for a case that is no finding of a run.
inline std::string page_beside_findings(const CaseOptions& options, const std::string& program) {
  if (!finding_number(options.text)) return "";
  const auto folder = std::filesystem::path(findings_named(options.findings)).parent_path();
  return (folder / fmt::format("{}-{}.html", program, options.text)).string();
}

/// A file beside the one asked for, which takes its name in one step at the end, or goes away with this
/// object. What is no file, as /dev/null or a pipe, is written to at once.
class PartialFile {
 public:
  /// Throws std::runtime_error with one sentence where the file can't be written.
  explicit PartialFile(const std::filesystem::path& asked)
      : asked_(asked),
        partial_(is_no_file(asked) ? asked.string() : fmt::format("{}.{}.part", asked.string(), getpid())) {
    std::error_code error;
    if (std::filesystem::is_directory(asked_, error)) fail();
    if (partial_ != asked_ && !std::ofstream(partial_, std::ios::binary)) fail();
  }
  ~PartialFile() {
    std::error_code ignored;
    if (partial_ != asked_) std::filesystem::remove(partial_, ignored);
  }
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  /// Where to write meanwhile.
  [[nodiscard]] std::string path() const { return partial_.string(); }

  void keep() {
    if (partial_ != asked_ && !put_in_place(partial_, asked_)) fail();
  }

 private:
  [[noreturn]] void fail() const {
    throw std::runtime_error(fmt::format("the file {} can't be written", asked_.string()));
  }

  std::filesystem::path asked_, partial_;
};

}  // namespace rayproof::viz
