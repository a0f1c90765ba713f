#pragma once
/// \file
/// The ray/cylinder methods, one line each.

#include <rayproof/cylinder/centred.hpp>
#include <rayproof/cylinder/printed.hpp>
#include <rayproof/cylinder/rounded.hpp>
#include <rayproof/cylinder/textbook.hpp>
#include <rayproof/method/topic.hpp>

namespace rayproof::cylinder {

struct Topic : RayTopic<Cylinder> {
  static constexpr const char* name = "cylinder";
  static constexpr double robust_bound = cylinder_robust_bound;
  static constexpr bool is_batched = true;
  using Methods = TypeList<Textbook, Centred, Rounded, Printed>;
  using Plain = Centred;
  using Exact = Rounded;
};

}  // namespace rayproof::cylinder
