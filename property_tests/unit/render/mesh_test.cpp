#include "unit/render/scenes.hpp"
#include "viz/render/scene/scene_reader.hpp"
#ifdef RAYPROOF_HAS_VTK
#include "viz/vtk/render/mesh_reader.hpp"
#endif

namespace rayproof::render {
namespace {

class Mesh : public SceneFiles {};

using Triangles = std::vector<Triangle<double>>;

/// The corners of all triangles, one after another.
std::vector<glm::dvec3> corners(const Triangles& triangles) {
  std::vector<glm::dvec3> all;
  for (const Triangle<double>& t : triangles) all.insert(all.end(), {t.a, t.b, t.c});
  return all;
}

const std::vector<glm::dvec3> square_in_two{{0, 0, 0}, {2, 0, 0},   {2, 2, 0.5},
                                            {0, 0, 0}, {2, 2, 0.5}, {0, 2, 0.5}};

const std::string off_square =
    "OFF # a square\n4 1 4\n0 0 0\n2 0 0 0.5 0.5 0.5\n2 2 +0.5\n\n0 2 5e-1\n4 0 1 2 3  255 0 0\n";

TEST_F(Mesh, AnOffFaceWithFourCornersBecomesTwoTriangles) {
  EXPECT_EQ(corners(read_off(write("a.off", off_square))), square_in_two);
  EXPECT_EQ(corners(read_off(write("b.off", "OFF 3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n"))).size(),
            3U);
}

TEST_F(Mesh, ABadOffFileIsRefusedByFileAndLine) {
  const std::vector<std::pair<std::string, std::string>> bad{
      {"", "line 1 is missing"},
      {"PLY\n", "line 1 must begin with OFF"},
      {"OFF\n3 x 0\n", "line 2 must have a number of faces, not \"x\""},
      {"OFF\n-3 1 0\n", "line 2 must have a number of vertices, not \"-3\""},
      {"OFF\n3 1 0\n0 0 0\n1 0\n", "line 4 must have 3 numbers, not \"\""},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n", "line 5 is missing"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", "line 6 must have 3 corners or more, not 2"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 6 must name one of the 3 vertices, from 0, not 3"},
      {"OFF\n99999999999 1 0\n0 0 0\n", "line 4 is missing"}};
  for (const auto& [text, sentence] : bad) {
    try {
      static_cast<void>(read_off(write("bad.off", text)));
      ADD_FAILURE() << text;
    } catch (const UnreadableFile& why) {
      EXPECT_NE(std::string(why.what()).find("bad.off: " + sentence), std::string::npos) << why.what();
    }
  }
}

#ifdef RAYPROOF_HAS_VTK
TEST_F(Mesh, ObjStlPlyAndOffGiveTheSameTriangles) {
  const std::string obj = "v 0 0 0\nv 2 0 0\nv 2 2 0.5\nv 0 2 0.5\nf 1 2 3\nf 1 3 4\n";
  const std::string stl =
      "solid square\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 2 2 "
      "0.5\nendloop\nendfacet\n"
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 2 0.5\nvertex 0 2 "
      "0.5\nendloop\nendfacet\nendsolid\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n2 0 0\n2 2 0.5\n0 2 0.5\n3 0 1 2\n3 0 2 3\n";
  EXPECT_EQ(corners(read_mesh(write("a.obj", obj))), square_in_two);
  EXPECT_EQ(corners(read_mesh(write("a.STL", stl))), square_in_two);
  EXPECT_EQ(corners(read_mesh(write("a.ply", ply))), square_in_two);
  EXPECT_EQ(corners(read_mesh(write("a.off", off_square))), square_in_two);
}

TEST_F(Mesh, AMeshThatNamesPointsItDoesNotHaveIsRefusedAndCrashesNothing) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n2 0 0\n2 2 0.5\n";
  for (const std::string& file :
       {write("far.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0.5\nf 1 2 99999999\n"),
        write("far.ply", ply + "3 0 1 99999999\n"), write("before.ply", ply + "3 0 1 -7\n"),
        write("short.ply", ply), write("none.ply", "ply\n")})
    EXPECT_THROW(static_cast<void>(read_mesh(file)), UnreadableFile) << file;
}

TEST_F(Mesh, WhatIsNoMeshIsRefusedByItsName) {
  for (const std::string& file :
       {write("a.txt", off_square), write("empty.obj", ""), write("junk.ply", "ply\nnonsense\n"),
        write("junk.stl", "\x01\x02"), write("points.obj", "v 0 0 0\n"), (folder / "gone.obj").string(),
        folder.string()}) {
    try {
      static_cast<void>(read_mesh(file));
      ADD_FAILURE() << file;
    } catch (const UnreadableFile& why) {
      EXPECT_NE(std::string(why.what()).find(file), std::string::npos) << why.what();
    }
  }
}
#endif

}  // namespace
}  // namespace rayproof::render
