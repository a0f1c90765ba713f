#pragma once
/// \file
/// Two outputs in one file would leave the later one alone, or a mixture.

#include <filesystem>
#include <stdexcept>
#include <string>

namespace rayproof {

/// Throws std::runtime_error with one sentence where two options, of these names, would write one file; an
/// empty path is none. What is no regular file (/dev/null) takes any number.
inline void refuse_one_file(const std::string& one, const std::filesystem::path& file,
                            const std::string& other, const std::filesystem::path& same) {
  std::error_code error;
  if (file.empty() || same.empty() ||
      std::filesystem::weakly_canonical(file, error) != std::filesystem::weakly_canonical(same, error))
    return;
  if (std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error)) return;
  throw std::runtime_error(one + " and " + other + " would write one file, " + file.string());
}

}  // namespace rayproof
