#ifdef RAYPROOF_HAS_VTK
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "unit/command.hpp"

namespace rayproof::viz {
namespace {

test::Ended draw_heat(const std::string& shape, const std::string& more) {
  return test::run("timeout 120 " RAYPROOF_BIN_DIR
                   "/rayproof-draw '{\"precision\": \"float32\", \"ray\": {\"origin\": [0, 0.2, -9], "
                   "\"direction\": [0, 0, 1]}, \"shape\": " +
                   shape + "}' " + more);
}

const std::string heat_picture = testing::TempDir() + "heat.png";

TEST(Heat, ATrianglesErrorsAreAPicture) {
  std::filesystem::remove(heat_picture);
  const auto [status, output] =
      draw_heat(R"({"type": "triangle", "a": [-1, -1, 0], "b": [2, 0, 1], "c": [0, 2, 0]})",
                "--method triangle/moller_trumbore --heat " + heat_picture);
  EXPECT_EQ(status, 0) << output;
  EXPECT_GT(std::filesystem::file_size(heat_picture), 10'000U);
}

TEST(Heat, WhatHasNoSuchPictureIsOneSentence) {
  for (const auto& [shape, more] :
       {std::pair<std::string, std::string>{R"({"type": "box", "min": [-1, -1, -1], "max": [1, 1, 1]})",
                                            "--method box/slabs"},
        {R"({"type": "sphere", "center": [0, 0, 0], "radius": 1})", ""}}) {
    const auto [status, output] = draw_heat(shape, more + " --heat " + heat_picture);
    EXPECT_EQ(status, 2) << output;
    EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 1) << output;
  }
}

}  // namespace
}  // namespace rayproof::viz
#endif
