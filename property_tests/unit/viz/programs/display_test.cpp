/// \file
/// rayproof draw --png on a machine without a display.

#include <array>
#include <fstream>
#include <iterator>

#include "unit/viz/programs/programs.hpp"

namespace rayproof::viz {
namespace {

#ifdef RAYPROOF_HAS_VTK
/// Width and height from a PNG's header.
std::array<unsigned, 2> png_size(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  if (bytes.size() < 24 || bytes.substr(1, 3) != "PNG") return {0, 0};
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes[i]);
    return value;
  };
  return {number(16), number(20)};
}

TEST_F(Programs, DrawWritesAPngWithoutADisplay) {
  const Ended ended = run(draw + cancelling + "--method quadratic/textbook --png " + file("a.png"));
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_EQ(ended.output, "");
  EXPECT_EQ(png_size(file("a.png"))[0], 1800U);
  EXPECT_GT(png_size(file("a.png"))[1], 600U);
  EXPECT_GT(std::filesystem::file_size(file("a.png")), 20000U);
}

TEST_F(Programs, DrawSaysWhatIsMissingWhereThereIsNoXvfb) {
  const Ended ended = run("PATH=/nowhere " + std::string(RAYPROOF_BIN_DIR) + "/rayproof-draw " + cancelling +
                          "--png " + file("a.png"));
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.output.find("Debian package xvfb"), std::string::npos) << ended.output;
}

/// Puts in Xvfb's place a script that fails as many times as that, and is then the real one.
std::string with_a_server_that_fails(int times, const std::filesystem::path& folder) {
  const std::filesystem::path script = folder / "Xvfb";
  std::ofstream(script) << "#!/bin/sh\ncd " << folder << "\necho try >> tries\n"
                        << "[ $(wc -l < tries) -le " << times << " ] && exit 1\n"
                        << "PATH=${PATH#*:} exec Xvfb \"$@\"\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  std::filesystem::remove(folder / "tries");
  return "env -u DISPLAY PATH=" + folder.string() + ":$PATH " RAYPROOF_BIN_DIR "/rayproof-draw ";
}

TEST_F(Programs, DrawTriesAgainWhereAServerDoesNotStart) {
  const Ended ended = run(with_a_server_that_fails(2, folder) + cancelling + "--png " + file("a.png"));
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_GT(png_size(file("a.png"))[0], 0U);
  const Ended given_up = run(with_a_server_that_fails(3, folder) + cancelling + "--png " + file("b.png"));
  EXPECT_EQ(given_up.status, 2);
  EXPECT_NE(given_up.output.find("did not start"), std::string::npos) << given_up.output;
}
#endif

}  // namespace
}  // namespace rayproof::viz
