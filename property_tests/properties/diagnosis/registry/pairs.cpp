/// \file
/// Two cures at once, for two faults that show in the same cases.

#include "properties/diagnosis/cures/cures.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

/// The cases that the second cure makes of those that the first one makes.
template <Change first, Change second>
Cases both(const Case& one) {
  Cases all;
  for (const Case& changed : first(one))
    for (Case& twice : second(changed)) all.push_back(std::move(twice));
  return all;
}

}  // namespace

std::vector<Hypothesis> pairs_of_cures() {
  std::vector<Hypothesis> all{
      cure("unit-direction+plain-interval", both<unit_direction, plain_interval>,
           "right as soon as the direction has length 1 and the interval is [0, inf], and not by one of "
           "these: two faults",
           gross, Keeps::verdict),
      cure("unit-direction+start-behind", both<unit_direction, start_behind>,
           "right as soon as the direction has length 1 and the ray starts before the shape, and not by one "
           "of these: two faults",
           gross, Keeps::verdict),
      cure("in-object-space+unit-direction", both<in_object_space, unit_direction>,
           "right as soon as there is no transform and the direction has length 1, and not by one of these: "
           "two faults",
           gross, Keeps::verdict),
      cure("unit-normal+unit-direction", both<unit_normal, unit_direction>,
           "right as soon as normal and direction both have length 1: the code takes both for unit vectors"),
      cure("tilted+plain-interval", both<tilted, plain_interval>,
           "right as soon as the direction is tilted off the axes and the interval is [0, inf], and not by "
           "one of these: two faults",
           gross, Keeps::verdict),
      cure("reversed-winding+start-behind", both<reversed_winding, start_behind>,
           "right as soon as the winding is reversed and the ray starts before the shape, and not by one of "
           "these: two faults",
           gross, Keeps::verdict),
      cure("larger-scene+unit-direction", both<larger_scene, unit_direction>,
           "right as soon as the scene is larger and the direction has length 1: an absolute epsilon, and a "
           "direction that is taken for a unit vector",
           gross, Keeps::verdict),
      cure("shape-at-zero+unit-direction", both<shape_at_zero, unit_direction>,
           "right as soon as the shape is at the origin of coordinates and the direction has length 1: two "
           "faults",
           gross, Keeps::verdict),
  };
  for (Hypothesis& one : all) one.is_pair = true;
  return all;
}

}  // namespace rayproof::diagnosis
