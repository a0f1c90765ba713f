/// \file
/// Pictures are written whole or not at all.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "viz/vtk/picture_png.hpp"

namespace rayproof::viz {
namespace {

std::string first_word_of(const std::filesystem::path& path) {
  std::string word;
  std::ifstream(path) >> word;
  return word;
}

TEST(RasterPng, LeavesAnOlderPictureAsItIsWhereTheNewOneCannotBeWritten) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "rayproof_raster_png";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder / "picture.png.new");  // where the new one would be written
  const std::filesystem::path picture = folder / "picture.png";
  std::ofstream(picture) << "older";
  EXPECT_THROW(write_png(Raster(4, 4, {}), picture.string()), std::runtime_error);
  EXPECT_EQ(first_word_of(picture), "older");

  std::filesystem::remove(folder / "picture.png.new");
  write_png(Raster(4, 4, {}), picture.string());
  EXPECT_NE(first_word_of(picture).find("PNG"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "picture.png.new"));
}

TEST(RasterPng, NeverRemovesWhatIsNoFile) {
  EXPECT_THROW(write_png(Raster(4, 4, {}), testing::TempDir()), std::runtime_error);
  EXPECT_TRUE(std::filesystem::is_directory(testing::TempDir()));
}

}  // namespace
}  // namespace rayproof::viz
