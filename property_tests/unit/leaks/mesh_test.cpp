/// \file
/// Meshes are read in every format, and only closed ones are searched.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "leaks/aim.hpp"

namespace rayproof::leaks {
namespace {

std::string file_with(const std::string& name, const std::string& text) {
  const std::string path = (std::filesystem::path(testing::TempDir()) / name).string();
  std::ofstream(path) << text;
  return path;
}

constexpr const char* tetrahedron_off =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
constexpr const char* tetrahedron_obj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
constexpr const char* tetrahedron_ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

std::string tetrahedron_stl() {
  std::string text = "solid t\n";
  for (const char* const corners :
       {"0 0 0,0 1 0,1 0 0", "0 0 0,1 0 0,0 0 1", "1 0 0,0 1 0,0 0 1", "0 0 0,0 0 1,0 1 0"}) {
    text += "facet normal 0 0 0\nouter loop\nvertex ";
    for (const char* c = corners; *c != 0; ++c)
      text += *c == ',' ? std::string("\nvertex ") : std::string(1, *c);
    text += "\nendloop\nendfacet\n";
  }
  return text + "endsolid t\n";
}

std::string trouble_with(const auto& action) {
  try {
    action();
  } catch (const std::runtime_error& trouble) {
    return trouble.what();
  }
  return "";
}

/// Six times the volume that the triangles enclose, to six decimals; positive where they wind as they should.
double volume_of(const ClosedMesh& mesh) {
  double sum = 0;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const Triangle<double> t = mesh.triangle(k);
    sum += dot(t.a, cross(t.b, t.c));
  }
  return std::round(sum * 1e6) / 1e6;
}

TEST(Mesh, IsTheSameInEveryFormat) {
  for (const auto& [name, text] :
       std::initializer_list<std::pair<const char*, std::string>>{{"t.off", tetrahedron_off},
                                                                  {"t.obj", tetrahedron_obj},
                                                                  {"t.ply", tetrahedron_ply},
                                                                  {"t.stl", tetrahedron_stl()}}) {
    const ClosedMesh mesh = read_mesh(file_with(name, text));
    EXPECT_EQ(mesh.vertices.size(), 4U) << name;
    EXPECT_EQ(mesh.triangles.size(), 4U) << name;
    EXPECT_EQ(topology_of(mesh).edges.size(), 6U) << name;
  }
}

TEST(Mesh, MayHaveWindowsLineEndsAndIndicesFromTheEnd) {
  std::string windows;
  for (const char* c = tetrahedron_obj; *c != 0; ++c) windows += *c == '\n' ? "\r\n" : std::string(1, *c);
  const std::string from_end =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n";
  for (const std::string& text : {windows, from_end}) {
    const ClosedMesh mesh = read_mesh(file_with("other.obj", text));
    EXPECT_EQ(topology_of(mesh).edges.size(), 6U);
    EXPECT_EQ(volume_of(mesh), 1);
  }
}

TEST(Mesh, IsRefusedWhereNoFaceHasAnArea) {
  const std::string file = file_with("flat.off", "OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 1\n3 0 1 2\n");
  EXPECT_EQ(trouble_with([&] { (void)read_mesh(file); }), file + ": no face has three corners that differ");
}

TEST(Mesh, ThatIsMadeIsClosed) {
  for (const std::string& name : made_meshes())
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      const ClosedMesh mesh = rounded(make_mesh(name), precision);
      const Topology topology = topology_of(mesh);
      EXPECT_EQ(2 * topology.edges.size(), 3 * mesh.triangles.size()) << name;
    }
}

TEST(Mesh, IsTurnedOutwardHoweverItWinds) {
  for (const std::string& name : made_meshes()) {
    const ClosedMesh mesh = make_mesh(name);
    ClosedMesh inward = mesh;
    for (auto& corners : inward.triangles) std::swap(corners[0], corners[1]);
    const ClosedMesh again = turned_outward(inward);
    EXPECT_EQ(volume_of(mesh), volume_of(again)) << name;
    EXPECT_GT(volume_of(mesh), 0) << name;
  }
}

TEST(Mesh, OfSquaresHasADiagonalInEach) {
  const ClosedMesh cube = make_mesh("cube");
  EXPECT_EQ(targets_of(cube).diagonals.size(), 6U);
}

TEST(Mesh, ThatAnnouncesMoreThanItHoldsIsRefusedAtOnce) {
  const std::string off = tetrahedron_off, ply = tetrahedron_ply;
  const auto with = [](std::string text, const std::string& old, const std::string& now) {
    return text.replace(text.find(old), old.size(), now);
  };
  const std::string header = "ply\nformat ascii 1.0\n";
  for (const auto& [name, text, words] : std::initializer_list<std::array<std::string, 3>>{
           {"vertices.off", with(off, "4 4 0", "2000000000 4 0"),
            "asks for more memory than its size allows"},
           {"faces.off", with(off, "4 4 0", "4 2000000000 0"), "asks for more memory than its size allows"},
           {"many.off", with(off, "4 4 0", "4 1000000000000000 0"), "is no mesh"},
           {"corners.off", with(off, "3 0 3 2", "2000000000 0 3 2"), "asks for more memory than its size"},
           {"negative.off", with(off, "3 0 3 2", "-3 0 3 2"), "asks for more memory than its size allows"},
           {"vertices.ply", with(ply, "vertex 4", "vertex 1000000000000000"),
            "announces 1e+15 elements \"vertex\""},
           {"faces.ply", with(ply, "face 4", "face 1000000000000000"), "announces 1e+15 elements \"face\""},
           {"bare.ply", header + "element vertex 1000000000000000\nend_header\n", "announces 1e+15 elements"},
           {"other.ply", header + "element other 1e300\nend_header\n", "announces 1e+300 elements \"other\""},
           {"corners.ply", with(with(ply, "uchar int", "uint int"), "3 0 3 2", "2000000000 0 3 2"), ""},
           {"endless.ply", header + "element face 10\n", "is no mesh"}}) {
    const std::string file = file_with(name, text);
    const std::string trouble = trouble_with([&file = file] { (void)read_mesh(file); });
    EXPECT_TRUE(trouble.starts_with(file)) << trouble;
    EXPECT_NE(trouble.find(words), std::string::npos) << trouble;
  }
}

TEST(Mesh, ThatIsAPipeOrADeviceIsRefused) {
  const std::string device = (std::filesystem::path(testing::TempDir()) / "zero.ply").string();
  std::filesystem::remove(device);
  std::filesystem::create_symlink("/dev/zero", device);
  EXPECT_EQ(trouble_with([&] { (void)read_mesh(device); }), device + " is no file that holds a mesh");
}

TEST(Mesh, ThatCannotBeUsedIsRefusedWithOneSentence) {
  EXPECT_EQ(trouble_with([] { (void)read_mesh("/nowhere.off"); }), "/nowhere.off does not exist");
  const std::string broken = file_with("broken.off", "OFF\n3 1 0\n0 0 0\n");
  EXPECT_EQ(trouble_with([&] { (void)read_mesh(broken); }),
            broken + " is no mesh in OFF, OBJ, STL or PLY that can be read");
  for (const auto& [name, text] : std::initializer_list<std::pair<const char*, std::string>>{
           {"zero.obj", std::string(tetrahedron_obj) + "f 0 1 2\n"},
           {"far.ply",
            std::string(tetrahedron_ply).replace(std::string(tetrahedron_ply).rfind("2\n"), 1, "99")}}) {
    const std::string wrong = file_with(name, text);
    EXPECT_EQ(trouble_with([&] { (void)read_mesh(wrong); }),
              wrong + ": a face names a vertex that there is not");
  }
  ClosedMesh huge = make_mesh("cube");
  huge.vertices[0].z = 1e30;
  EXPECT_EQ(trouble_with([&] { (void)rounded(huge, Precision::float32); }),
            "the mesh cube has a coordinate of size 1e+30: in float32 lengths are judged up to 2^60");
  EXPECT_EQ(rounded(huge, Precision::float64).vertices[0].z, 1e30);
  ClosedMesh open = make_mesh("cube");
  open.triangles.pop_back();
  EXPECT_NE(trouble_with([&] {
              (void)topology_of(open);
            }).find("the mesh cube is not closed: the edge from vertex"),
            std::string::npos);
  ClosedMesh doubled = make_mesh("cube");
  doubled.triangles.push_back(doubled.triangles.front());
  EXPECT_NE(trouble_with([&] { (void)topology_of(doubled); }).find("has two triangles on one side"),
            std::string::npos);
}

}  // namespace
}  // namespace rayproof::leaks
