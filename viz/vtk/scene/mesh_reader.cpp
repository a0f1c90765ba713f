#include "viz/vtk/scene/mesh_reader.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkErrorCode.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkTriangleFilter.h>

#include <fstream>

#include "viz/scene/mesh_file.hpp"
#include "viz/scene/off_mesh.hpp"
#include "viz/scene/scene_reader.hpp"

namespace rayproof::render {
namespace {

/// VTK's own words about a bad file would come between ours.
class Silence {
 public:
  Silence() : was_loud_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::GlobalWarningDisplayOff(); }
  ~Silence() { vtkObject::SetGlobalWarningDisplay(was_loud_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int was_loud_;
};

template <class Reader>
std::vector<Triangle<double>> read_by(const std::filesystem::path& file) {
  const Silence silence;
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
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

std::vector<Triangle<double>> read_by_name(const std::filesystem::path& file) {
  const std::string ending = ending_of(file);
  if (ending == "obj") return read_by<vtkOBJReader>(file);
  if (ending == "stl") return read_by<vtkSTLReader>(file);
  if (ending == "ply") return read_by<vtkPLYReader>(file);
  if (ending == "off") return read_off(file);
  throw UnreadableFile(fmt::format(
      "{} is no mesh that can be read: its name must end in .obj, .stl, .ply or .off", file.string()));
}

}  // namespace

std::vector<Triangle<double>> read_mesh(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file) || !std::ifstream(file))
    throw UnreadableFile(fmt::format("the file {} can't be read", file.string()));
  std::vector<Triangle<double>> triangles = read_by_name(file);
  if (triangles.empty()) throw UnreadableFile(fmt::format("{} holds no triangle", file.string()));
  return triangles;
}

}  // namespace rayproof::render
