#pragma once
/// \file
/// Folders and files that a program reads and writes: each trouble is one sentence that names the file.

#include <array>
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

/// Whether a file was opened to be read. A folder opens, too, and only then can't be read.
[[nodiscard]] inline bool is_readable(const std::ifstream& file, const std::filesystem::path& path) {
  std::error_code error;
  return file && !std::filesystem::is_directory(path, error);
}

/// A file opened to be read. Throws std::runtime_error.
[[nodiscard]] inline std::ifstream opened_to_read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!is_readable(file, path)) throw std::runtime_error(path.string() + " cannot be read");
  return file;
}

/// As much as is taken into memory as one text or line: what never ends, as /dev/zero, is refused.
inline constexpr std::size_t longest_text = std::size_t{1} << 30;

/// The next line as std::getline gives it, and whether there was one. Throws std::runtime_error, which names
/// the file, for a line beyond the bound.
inline bool read_line(std::istream& in, std::string& line, const std::string& name) {
  constexpr auto end_of_file = std::char_traits<char>::eof();
  line.clear();
  for (int next = in.get(); next != end_of_file; next = in.get()) {
    if (next == '\n') return true;
    if (line.size() == longest_text) throw std::runtime_error(name + " has a line of more than 1 GiB");
    line += static_cast<char>(next);
  }
  return !line.empty();
}

/// All that is left in the stream. Throws std::runtime_error, which names the file, for more than the bound.
[[nodiscard]] inline std::string whole_text(std::istream& in, const std::string& name) {
  std::string text;
  for (std::array<char, 65536> part{}; in.read(part.data(), part.size()) || in.gcount() > 0;) {
    if (text.size() + part.size() > longest_text) throw std::runtime_error(name + " holds more than 1 GiB");
    text.append(part.data(), static_cast<std::size_t>(in.gcount()));
  }
  return text;
}

/// A file opened to be written anew. Throws std::runtime_error.
[[nodiscard]] inline std::ofstream opened(const std::filesystem::path& path) {
  std::ofstream file(path);
  if (!file) throw std::runtime_error(path.string() + " cannot be written");
  return file;
}

/// Throws std::runtime_error where a file could not be written, which long work would learn at its end; an
/// empty path is none.
inline void expect_writable(const std::filesystem::path& path) {
  std::error_code error;
  if (path.empty() ||
      (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error)))
    return;
  const bool was_there = std::filesystem::exists(path, error);
  if (!std::ofstream(path, std::ios::app)) throw std::runtime_error(path.string() + " cannot be written");
  if (!was_there) std::filesystem::remove(path, error);
}

/// Ends a file; on a full disk what was written before may not have reached it. Throws std::runtime_error.
inline void finish(std::ostream& file, const std::filesystem::path& path) {
  if (!(file << std::flush))
    throw std::runtime_error(path.string() + " cannot be written: is the disk full?");
}

/// Puts a whole file that stands beside `path` in its place, in one step; false where that can't be. A link
/// goes on to lead to the file; what is no file (/dev/stdout, a pipe) is written to, and never replaced.
[[nodiscard]] inline bool put_in_place(const std::filesystem::path& beside,
                                       const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error)) {
    std::ofstream out(path, std::ios::binary);
    if (std::filesystem::file_size(beside, error) > 0) out << std::ifstream(beside, std::ios::binary).rdbuf();
    return static_cast<bool>(out << std::flush);
  }
  const std::filesystem::path place = std::filesystem::weakly_canonical(path, error);
  if (!error) std::filesystem::rename(beside, place, error);
  return !error;
}

/// Writes the file anew; whatever ends the program or fills the disk meanwhile, either the old or the new
/// text stands there. What is no file (/dev/stdout, a pipe) is written to. Throws std::runtime_error.
inline void write_file(const std::filesystem::path& path, const std::string& text) {
  std::error_code error;
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error)) {
    std::ofstream file = opened(path);
    return finish(file << text, path);
  }
  // Beside the file itself where the path is a link: it cannot be moved from one disk to another.
  const std::filesystem::path place = std::filesystem::weakly_canonical(path, error);
  const bool is_there = !error && std::filesystem::is_regular_file(place, error);
  const std::filesystem::path beside = (is_there ? place : path).string() + ".new";
  bool is_written = false;
  {
    std::ofstream file(beside, std::ios::binary);
    is_written = static_cast<bool>(file << text << std::flush);
  }
  is_written = is_written && put_in_place(beside, path);
  if (std::filesystem::is_regular_file(beside, error)) std::filesystem::remove(beside, error);
  if (is_written) return;
  throw std::runtime_error(path.string() +
                           " cannot be written: is its folder writable, and is there room on the disk?");
}

}  // namespace rayproof
