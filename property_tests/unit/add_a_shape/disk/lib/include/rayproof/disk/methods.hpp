#pragma once
/// \file
/// The ray/disk methods, one line each.

#include <rayproof/disk/projected.hpp>
#include <rayproof/method/topic.hpp>

namespace rayproof::disk {

/// The topic as the registries see it.
struct Topic : RayTopic<Disk> {
  static constexpr const char* name = "disk";
  static constexpr double robust_bound = disk_robust_bound;
  using Methods = TypeList<Projected>;
  using Plain = Projected;
  using Exact = Projected;  // until there is an exact one
};

}  // namespace rayproof::disk
