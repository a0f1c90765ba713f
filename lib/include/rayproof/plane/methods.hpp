#pragma once
/// \file
/// The ray/plane methods, one line each.

#include <rayproof/method/topic.hpp>
#include <rayproof/plane/implicit.hpp>
#include <rayproof/plane/parametric.hpp>
#include <rayproof/plane/point_normal.hpp>
#include <rayproof/plane/printed_implicit.hpp>
#include <rayproof/plane/printed_parallel.hpp>
#include <rayproof/plane/rounded.hpp>

namespace rayproof::plane {

struct Topic : RayTopic<Plane> {
  static constexpr const char* name = "plane";
  static constexpr double robust_bound = plane_robust_bound;
  static constexpr bool is_batched = true;
  using Methods =
      TypeList<ByEquation, ByPointAndNormal, ByParameters, Rounded, PrintedImplicit, PrintedParallel>;
  using Plain = ByEquation;
  using Exact = Rounded;
};

}  // namespace rayproof::plane
