/// \file
/// rayproof leak as somebody outside runs it.

#include <gtest/gtest.h>

#include "unit/command.hpp"

namespace rayproof {
namespace {

test::Ended leak(const std::string& options) {
  return test::run(std::string(RAYPROOF_BIN_DIR) + "/rayproof-leak --out " + testing::TempDir() + "leak " +
                   options);
}

TEST(LeakProgram, SaysThatSoundMethodsAreTight) {
  const test::Ended ended = leak("cube --rays 2000");
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_NE(ended.output.find("no sound method leaks or hits twice"), std::string::npos) << ended.output;
}

TEST(LeakProgram, RefusesWhatItCannotUseWithOneSentence) {
  const test::Ended missing = leak("/nowhere.off");
  EXPECT_EQ(missing.status, 2);
  EXPECT_EQ(missing.output, "rayproof leak: /nowhere.off does not exist\n");
  const test::Ended unknown = leak("cube --method nobody");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_EQ(unknown.output, "rayproof leak: there is no method \"nobody\" of triangles\n");
}

}  // namespace
}  // namespace rayproof
