#pragma once
/// \file
/// What the tests of the programs ask them: a program by its name, and two cases with their answers.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "unit/command.hpp"

namespace rayproof::test {

/// Runs `rayproof-COMMAND`.
inline Ended run_program(const std::string& command) {
  return run(std::string(RAYPROOF_BIN_DIR) + "/rayproof-" + command);
}

/// A file that is there as long as the object.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text) { std::ofstream(path_) << text; }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::filesystem::remove(path_); }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_ =
      (std::filesystem::temp_directory_path() / ("rayproof_case_" + std::to_string(::getpid()) + ".jsonl"))
          .string();
};

inline constexpr auto quadratic_case = R"({"query": "quadratic", "a": 1, "b": -3, "c": 2})";
inline constexpr auto sphere_case =
    R"({"id": 7, "precision": "float32", "ray": {"origin": [0,0,-5], "direction": [0,0,1], "t_min": 0, "t_max": "inf"}, )"
    R"("shape": {"type": "sphere", "center": [0,0,0], "radius": 1}, "transform": [[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]})";
inline constexpr auto sphere_answer =
    R"({"id": 7, "verdict": "hit", "contact": "crossing", "hits": [{"t": 4, "t_hex": "0x1p+2"}, {"t": 6, "t_hex": "0x1.8p+2"}], )"
    R"("point": [0, 0, -1], "normal": [0, 0, -1]})";
inline constexpr auto quadratic_answer =
    R"({"kind": "two", "roots": [{"x": 1, "x_hex": "0x1p+0"}, {"x": 2, "x_hex": "0x1p+1"}]})";

}  // namespace rayproof::test
