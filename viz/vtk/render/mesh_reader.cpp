#include "viz/vtk/render/mesh_reader.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <fstream>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>

#include "case/memory_bound.hpp"
#include "viz/render/scene/scene_reader.hpp"

namespace rayproof::render {
namespace {

using Triangles = std::vector<Triangle<double>>;

/// Writes all bytes; false where the reader is gone.
bool write_all(int to, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(to, bytes.data(), bytes.size());
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
    const ssize_t got = ::read(from, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    bytes.insert(bytes.end(), block.begin(), block.begin() + got);
  }
  Triangles triangles(bytes.size() / sizeof(Triangle<double>));
  std::copy_n(bytes.begin(), triangles.size() * sizeof(Triangle<double>),
              std::as_writable_bytes(std::span(triangles)).begin());
  return triangles;
}

/// What `make` gives, made in a child process that ends with it; nothing where it throws, crashes, or takes
/// more than a minute of processor time. What the child says on standard error is lost. Call it before there
/// are other threads.
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

/// Throws where a cell names a point that is not there: VTK's filters do not ask.
void check_points(vtkCellArray& cells, vtkIdType count) {
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < cells.GetNumberOfCells(); ++cell) {
    cells.GetCellAtId(cell, points);
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i) {
      if (points->GetId(i) < 0 || points->GetId(i) >= count)
        throw std::out_of_range("a cell names a point that is not there");
    }
  }
}

template <class Reader>
std::vector<Triangle<double>> read_by(const std::filesystem::path& file) {
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  check_points(*reader->GetOutput()->GetPolys(), reader->GetOutput()->GetNumberOfPoints());
  check_points(*reader->GetOutput()->GetStrips(), reader->GetOutput()->GetNumberOfPoints());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->SetInputConnection(reader->GetOutputPort());
  triangles->Update();
  vtkPolyData& mesh = *triangles->GetOutput();
  std::vector<Triangle<double>> all;
  vtkNew<vtkIdList> corners;
  const auto vertex = [&](vtkIdType corner) {
    double at[3];
    mesh.GetPoint(corners->GetId(corner), at);
    return glm::dvec3(at[0], at[1], at[2]);
  };
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfPolys(); ++cell) {
    mesh.GetPolys()->GetCellAtId(cell, corners);
    all.push_back({vertex(0), vertex(1), vertex(2)});
  }
  return all;
}

/// "obj" of "Bunny.OBJ".
std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  if (ending.starts_with('.')) ending.erase(0, 1);
  for (char& c : ending) c = static_cast<char>('A' <= c && c <= 'Z' ? c + ('a' - 'A') : c);
  return ending;
}

/// VTK's reader of the format; null where it has none.
std::vector<Triangle<double>> (*reader_of(const std::string& ending))(const std::filesystem::path&) {
  if (ending == "obj") return read_by<vtkOBJReader>;
  if (ending == "stl") return read_by<vtkSTLReader>;
  return ending == "ply" ? read_by<vtkPLYReader> : nullptr;
}

std::vector<Triangle<double>> read_by_name(const std::filesystem::path& file) {
  const std::string ending = ending_of(file);
  if (ending == "off") return read_off(file);
  const auto read = reader_of(ending);
  if (read == nullptr) {
    throw UnreadableFile(fmt::format(
        "{} is no mesh that can be read: its name must end in .obj, .stl, .ply or .off", file.string()));
  }
  // Some files that are not well-formed crash VTK 9.1's readers: let that be another process's end.
  const auto triangles = made_apart([&] {
    const MemoryBound bound(memory_for_mesh(std::filesystem::file_size(file)));
    return read(file);
  });
  if (!triangles) throw UnreadableFile(fmt::format("{} is no well-formed {} file", file.string(), ending));
  return *triangles;
}

}  // namespace

std::vector<Triangle<double>> read_mesh(const std::filesystem::path& file) {
  // A pipe or a device may never end.
  if (!std::filesystem::is_regular_file(file) || !std::ifstream(file))
    throw UnreadableFile(fmt::format("the file {} can't be read", file.string()));
  std::vector<Triangle<double>> triangles = read_by_name(file);
  if (triangles.empty()) throw UnreadableFile(fmt::format("{} holds no triangle", file.string()));
  return triangles;
}

}  // namespace rayproof::render
