#include "viz/vtk/picture_png.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "unit/command.hpp"

namespace rayproof::viz {
namespace {

const std::string film_program = "timeout 60 " RAYPROOF_BIN_DIR "/rayproof-walk ";

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Movie, IsAnOggFileWithATheoraHeaderOfThePicturesSizeAndAllPictures) {
  const std::string path = testing::TempDir() + "film.ogv";
  {
    Movie movie(path, 8);
    for (int i = 0; i < 3; ++i) movie.add(Raster(64, 36, {static_cast<std::uint8_t>(80 * i), 90, 30}), i + 1);
  }
  const std::string bytes = bytes_of(path);
  ASSERT_EQ(bytes.substr(0, 4), "OggS");
  // Theora I specification, section 6.2: after the signature three bytes of version, the size in blocks of
  // 16, then the width and height of the picture, 24 bits each.
  const std::size_t header = bytes.find("\x80theora");
  ASSERT_NE(header, std::string::npos);
  const auto number_at = [&](std::size_t place, int count) {
    int sum = 0;
    for (int i = 0; i < count; ++i)
      sum = 256 * sum + static_cast<unsigned char>(bytes.at(header + place + static_cast<std::size_t>(i)));
    return sum;
  };
  EXPECT_EQ(number_at(14, 3), 64);
  EXPECT_EQ(number_at(17, 3), 36);
  // Ogg, RFC 3533: the header type of the last page.
  const std::size_t last = bytes.rfind("OggS");
  EXPECT_EQ(bytes.at(last + 5) & 4, 4);  // the stream's end
}

TEST(MovieProgram, AWrongNameIsOneSentenceAndStatus2) {
  for (const std::string& name : {std::string("film.mp4"), std::string("/no/such/folder/film.ogv")}) {
    test::Running program(film_program + "ray --movie " + name + " 2>&1");
    const auto [status, output] = program.wait();
    EXPECT_EQ(status, 2) << output;
    EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 1) << output;
    EXPECT_NE(output.find(name), std::string::npos) << output;
  }
}

TEST(MovieProgram, AfterCtrlCThereIsNoFileAndStatus130) {
  const std::filesystem::path here = testing::TempDir() + "interrupted-film";
  std::filesystem::create_directory(here);
  test::Running program("timeout --preserve-status --signal=INT 1.5 " RAYPROOF_BIN_DIR
                        "/rayproof-walk all --movie " +
                        (here / "film.ogv").string());
  EXPECT_EQ(program.wait().status, 130);
  EXPECT_TRUE(std::filesystem::is_empty(here));
  std::filesystem::remove_all(here);
}

}  // namespace
}  // namespace rayproof::viz
