#pragma once
/// \file
/// The ray/polygon methods, one line each.

#include <rayproof/method/topic.hpp>
#include <rayproof/polygon/parity.hpp>
#include <rayproof/polygon/printed_parity.hpp>
#include <rayproof/polygon/rounded.hpp>
#include <rayproof/polygon/winding.hpp>

namespace rayproof::polygon {

struct Topic : RayTopic<Polygon> {
  static constexpr const char* name = "polygon";
  static constexpr double robust_bound = polygon_robust_bound;
  using Methods = TypeList<Parity, Winding, Rounded, PrintedParity>;
  using Plain = Winding;
  using Exact = Rounded;
};

}  // namespace rayproof::polygon
