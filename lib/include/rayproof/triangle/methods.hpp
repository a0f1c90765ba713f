#pragma once
/// \file
/// The ray/triangle methods, one line each.

#include <rayproof/method/topic.hpp>
#include <rayproof/triangle/cramer.hpp>
#include <rayproof/triangle/moller_trumbore.hpp>
#include <rayproof/triangle/plane_projection.hpp>
#include <rayproof/triangle/plucker.hpp>
#include <rayproof/triangle/printed_lambda2.hpp>
#include <rayproof/triangle/printed_parallelogram.hpp>
#include <rayproof/triangle/printed_xy.hpp>
#include <rayproof/triangle/rounded.hpp>
#include <rayproof/triangle/woop.hpp>

namespace rayproof::triangle {

struct Topic : RayTopic<Triangle> {
  static constexpr const char* name = "triangle";
  static constexpr double robust_bound = triangle_robust_bound;
  static constexpr bool is_batched = true;
  static constexpr bool has_columns = true;
  using Methods = TypeList<Cramer, PlaneProjection, MollerTrumbore, Woop, Plucker, Rounded,
                           PrintedParallelogram, PrintedLambda2, PrintedXy>;
  using Plain = Woop;
  using Exact = Rounded;
};

}  // namespace rayproof::triangle
