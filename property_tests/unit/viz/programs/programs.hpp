#pragma once
/// \file
/// What the tests of explain, draw and walk share: the programs, two cases, and a folder for what they write.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "unit/command.hpp"

namespace rayproof::viz {

using test::Ended;
using test::run;

inline const std::string explain = std::string(RAYPROOF_BIN_DIR) + "/rayproof-explain ";
inline const std::string walk_program = "env -u DISPLAY " RAYPROOF_BIN_DIR "/rayproof-walk ";
inline const std::string draw = "env -u DISPLAY " RAYPROOF_BIN_DIR "/rayproof-draw ";
inline const std::string cancelling =
    R"('{"query":"quadratic","precision":"float32","a":1,"b":1000,"c":1}' )";
inline const std::string a_sphere =
    R"('{"ray":{"origin":[0,0,-5],"direction":[0,0,1]},"shape":{"type":"sphere","center":[0,0,0],"radius":1}}' )";

class Programs : public testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::path(testing::TempDir()) / ("rayproof-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  [[nodiscard]] std::string file(const std::string& name) const { return (folder / name).string(); }

  std::filesystem::path folder;
};

}  // namespace rayproof::viz
