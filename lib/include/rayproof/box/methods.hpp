#pragma once
/// \file
/// The ray/box methods, one line each.

#include <rayproof/box/padded.hpp>
#include <rayproof/box/printed_slabs.hpp>
#include <rayproof/box/rounded.hpp>
#include <rayproof/box/slabs.hpp>
#include <rayproof/box/slabs_inverse.hpp>
#include <rayproof/method/topic.hpp>

namespace rayproof::box {

struct Topic : RayTopic<Box> {
  static constexpr const char* name = "box";
  static constexpr double robust_bound = box_robust_bound;
  static constexpr bool is_batched = true;
  static constexpr bool has_columns = true;
  using Methods = TypeList<Slabs, SlabsInverse, Padded, Rounded, PrintedSlabs>;
  using Plain = Slabs;
  using Exact = Rounded;
};

}  // namespace rayproof::box
