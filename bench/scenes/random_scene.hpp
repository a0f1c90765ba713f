#pragma once
/// \file
/// Random scenes of N small objects in a cube, and rays through it.

#include <rayproof/sphere.hpp>
#include <rayproof/triangle.hpp>
#include <string>
#include <vector>

namespace rayproof::report {

/// What a scene is made of.
struct RandomScene {
  std::vector<Sphere<float>> spheres{};
  std::vector<Triangle<float>> triangles{};
};

/// A scene of `count` objects, the same for one count always: "spheres", "triangles", or "mixed" with as many
/// of the one as of the other. All together they cover the view of the cube about once.
[[nodiscard]] RandomScene random_scene(const std::string& kind, std::size_t count);

/// 4096 rays from far outside the cube to points in it.
[[nodiscard]] std::vector<Ray<float>> rays_through_scene();

}  // namespace rayproof::report
