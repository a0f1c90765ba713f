#pragma once
/// \file
/// The ray/sphere methods, one line each.

#include <rayproof/method/topic.hpp>
#include <rayproof/sphere/centred.hpp>
#include <rayproof/sphere/compensated.hpp>
#include <rayproof/sphere/half_b.hpp>
#include <rayproof/sphere/printed_2ac.hpp>
#include <rayproof/sphere/printed_half_b.hpp>
#include <rayproof/sphere/printed_unit_direction.hpp>
#include <rayproof/sphere/rounded.hpp>
#include <rayproof/sphere/stable.hpp>
#include <rayproof/sphere/textbook.hpp>

namespace rayproof::sphere {

struct Topic : RayTopic<Sphere> {
  static constexpr const char* name = "sphere";
  static constexpr double robust_bound = sphere_robust_bound;
  static constexpr bool is_batched = true;
  static constexpr bool has_columns = true;
  using Methods = TypeList<Textbook, HalfB, Stable, Centred, Compensated, Rounded, Printed2ac, PrintedHalfB,
                           PrintedUnitDirection>;
  using Plain = Centred;
  using Exact = Rounded;
};

}  // namespace rayproof::sphere
