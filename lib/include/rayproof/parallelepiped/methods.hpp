#pragma once
/// \file
/// The ray/parallelepiped methods, one line each.

#include <rayproof/method/topic.hpp>
#include <rayproof/parallelepiped/face_planes.hpp>
#include <rayproof/parallelepiped/rounded.hpp>
#include <rayproof/parallelepiped/unit_cube.hpp>

namespace rayproof::parallelepiped {

struct Topic : RayTopic<Parallelepiped> {
  static constexpr const char* name = "parallelepiped";
  static constexpr double robust_bound = parallelepiped_robust_bound;
  static constexpr bool is_batched = true;
  static constexpr bool has_columns = true;
  using Methods = TypeList<FacePlanes, UnitCube, Rounded>;
  using Plain = FacePlanes;
  using Exact = Rounded;
};

}  // namespace rayproof::parallelepiped
