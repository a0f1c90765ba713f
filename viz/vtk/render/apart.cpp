#include "viz/vtk/render/mesh_reader.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <span>

namespace rayproof::render {
namespace {

using Triangles = std::vector<Triangle<double>>;

/// Writes all bytes; false where the reader is gone.
bool write_all(int to, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(to, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

[[noreturn]] void be_child(int to, const std::function<Triangles()>& make) {
  const int null = open("/dev/null", O_RDWR);
  dup2(null, STDERR_FILENO);
  dup2(null, STDOUT_FILENO);
  constexpr rlimit a_minute{60, 60};
  setrlimit(RLIMIT_CPU, &a_minute);
  constexpr rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  try {
    const Triangles made = make();
    // _exit: the parent's files and threads are not this process's to tidy up.
    _exit(write_all(to, std::as_bytes(std::span(made))) ? 0 : 1);
  } catch (const std::exception&) {
    _exit(1);
  }
}

/// The triangles that come through the pipe until it ends; whole ones alone.
Triangles read_all(int from) {
  std::vector<std::byte> bytes;
  std::array<std::byte, 65536> block{};
  for (;;) {
    const ssize_t got = read(from, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    bytes.insert(bytes.end(), block.begin(), block.begin() + got);
  }
  Triangles triangles(bytes.size() / sizeof(Triangle<double>));
  std::copy_n(bytes.begin(), triangles.size() * sizeof(Triangle<double>),
              std::as_writable_bytes(std::span(triangles)).begin());
  return triangles;
}

}  // namespace

std::optional<Triangles> made_apart(const std::function<Triangles()>& make) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return std::nullopt;
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    be_child(ends[1], make);
  }
  close(ends[1]);
  Triangles triangles = child > 0 ? read_all(ends[0]) : Triangles();
  close(ends[0]);
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (child < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  return triangles;
}

}  // namespace rayproof::render
