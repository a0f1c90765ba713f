#pragma once
/// \file
/// Folders and files that a program writes: each trouble is one sentence that names the file.

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace rayproof {

/// Makes a folder, and those that it lies in. Throws std::runtime_error where that cannot be.
inline void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw std::runtime_error("the folder " + folder.string() + " cannot be made: " + error.message());
}

/// A file opened to be written anew. Throws std::runtime_error.
[[nodiscard]] inline std::ofstream opened(const std::filesystem::path& path) {
  std::ofstream file(path);
  if (!file) throw std::runtime_error(path.string() + " cannot be written");
  return file;
}

/// Ends a file; on a full disk what was written before may not have reached it. Throws std::runtime_error.
inline void finish(std::ostream& file, const std::filesystem::path& path) {
  if (!(file << std::flush))
    throw std::runtime_error(path.string() + " cannot be written: is the disk full?");
}

inline void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file = opened(path);
  file << text;
  finish(file, path);
}

/// Writes the file anew; whatever ends the program meanwhile, either the old or the new text stands there.
inline void replace_file(const std::filesystem::path& path, const std::string& text) {
  const std::filesystem::path beside = path.string() + ".new";
  std::error_code error;
  bool is_written = false;
  {
    std::ofstream file(beside);
    is_written = static_cast<bool>(file << text << std::flush);
  }
  if (is_written) std::filesystem::rename(beside, path, error);
  if (is_written && !error) return;
  std::filesystem::remove(beside, error);
  throw std::runtime_error(path.string() +
                           " cannot be written: is its folder writable, and is there room on the disk?");
}

}  // namespace rayproof
