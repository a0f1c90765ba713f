#pragma once
/// \file
/// Mesh files, known by the ends of their names.

#include <filesystem>
#include <string>

namespace rayproof::render {

/// "obj" of "Bunny.OBJ".
[[nodiscard]] inline std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  if (ending.starts_with('.')) ending.erase(0, 1);
  for (char& c : ending) c = static_cast<char>('A' <= c && c <= 'Z' ? c + ('a' - 'A') : c);
  return ending;
}

}  // namespace rayproof::render
