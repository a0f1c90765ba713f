#include "case/files.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <iterator>
#include <sstream>

namespace rayproof {
namespace {

namespace fs = std::filesystem;

/// A folder that is there as long as the object.
struct Folder {
  fs::path path = fs::path(testing::TempDir()) / ("rayproof_files_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path); }
};

std::string text_of(const fs::path& path) {
  std::ifstream in = opened_to_read(path);
  return whole_text(in, path.string());
}

TEST(write_file, leaves_a_link_a_link_to_the_new_text) {
  const Folder folder;
  write_file(folder.path / "file", "old");
  fs::create_symlink("file", folder.path / "link");
  write_file(folder.path / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder.path / "link"));
  EXPECT_EQ(text_of(folder.path / "file"), "new");
}

TEST(write_file, writes_to_a_pipe_and_leaves_it_a_pipe) {
  const Folder folder;
  const fs::path pipe = folder.path / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::fstream reader(pipe, std::ios::in | std::ios::out);  // open at both ends, so that nobody waits
  write_file(pipe, "new\n");
  std::string line;
  std::getline(reader, line);
  EXPECT_EQ(line, "new");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(write_file, leaves_nothing_beside_the_file) {
  const Folder folder;
  write_file(folder.path / "file", "new");
  EXPECT_THROW(write_file(folder.path / "no folder" / "file", "new"), std::runtime_error);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path), {}), 1);
}

TEST(opened_to_read, refuses_a_folder_and_what_is_not_there) {
  const Folder folder;
  EXPECT_THROW((void)opened_to_read(folder.path), std::runtime_error);
  EXPECT_THROW((void)opened_to_read(folder.path / "file"), std::runtime_error);
}

TEST(read_line, gives_the_lines_that_getline_gives) {
  for (const char* text : {"", "a", "a\n", "a\nb", "\n\na\n\n"}) {
    std::istringstream ours(text), plain(text);
    std::string line, expected;
    while (std::getline(plain, expected)) {
      ASSERT_TRUE(read_line(ours, line, "text")) << text;
      EXPECT_EQ(line, expected);
    }
    EXPECT_FALSE(read_line(ours, line, "text")) << text;
  }
}

TEST(whole_text, refuses_a_file_that_never_ends) {
  std::ifstream zeros = opened_to_read("/dev/zero");
  EXPECT_THROW((void)whole_text(zeros, "/dev/zero"), std::runtime_error);
}

}  // namespace
}  // namespace rayproof
