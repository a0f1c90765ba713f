#include "generators/family.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/cylinder/aimed.hpp"
#include "generators/shapes/cylinder/shapes.hpp"

namespace rayproof {

std::vector<Family> cylinder_families() {
  using namespace cylinder_family;
  const char* const topic = "cylinder";
  const MinimumShare in_reach{"in reach", 0.95};
  // The first family that breaks a property gives the counterexample: the most telling ones come first.
  return {
      family<AsLaidOut<Everyday>>(topic, {in_reach, {"hit", 0.36}, {"miss", 0.48}, {"behind", 0.04}}),
      family<AsLaidOut<Far>>(topic, {in_reach, {"hit", 0.56}, {"miss", 0.28}}),
      family<AsLaidOut<Grazing>>(topic,
                                 {in_reach, {"hit", 0.54}, {"miss", 0.3}, {"tangent", 0.11}, {"rim", 0.11}}),
      family<AsLaidOut<Rims>>(topic,
                              {in_reach, {"hit", 0.68}, {"miss", 0.15}, {"rim", 0.36}, {"in surface", 0.02}}),
      family<AsLaidOut<Caps>>(topic, {in_reach, {"hit", 0.61}, {"miss", 0.23}}),
      family<AsLaidOut<AxisParallel>>(
          topic, {in_reach, {"hit", 0.23}, {"miss", 0.61}, {"rim", 0.16}, {"in surface", 0.16}}),
      family<AsLaidOut<CapPlanes>>(topic, {in_reach, {"hit", 0.81}, {"miss", 0.02}, {"rim", 0.82}}),
      family<AsLaidOut<FlatEllipses>>(topic, {in_reach, {"hit", 0.57}, {"miss", 0.27}}),
      family<AsLaidOut<Inside>>(
          topic, {in_reach, {"hit", 0.63}, {"miss", 0.21}, {"cut", 0.54}, {"from inside", 0.54}}),
      family<AsLaidOut<Surface>>(
          topic,
          {in_reach, {"hit", 0.66}, {"miss", 0.18}, {"rim", 0.1}, {"cut", 0.24}, {"from inside", 0.1}}),
      family<AsLaidOut<NoHeight>>(topic, {in_reach, {"hit", 0.56}, {"miss", 0.28}, {"rim", 0.38}}),
      family<CutShort<Cut>>(topic, {in_reach,
                                    {"hit", 0.58},
                                    {"miss", 0.25},
                                    {"tangent", 0.01},
                                    {"rim", 0.14},
                                    {"in surface", 0.02},
                                    {"behind", 0.22},
                                    {"cut", 0.28}}),
      family<Transformed<Everyday, Rims>>(topic, {in_reach, {"hit", 0.48}, {"miss", 0.36}, {"rim", 0.12}}),
      family<AnySize<Everyday>>(topic, {{"hit", 0.36}, {"miss", 0.48}, {"behind", 0.04}}),
      family<Special<Cylinder<double>>>(topic, {{"hit", 0.06}, {"miss", 0.76}}),
      family<BitPatterns<Cylinder<double>>>(topic, {{"hit", 0.05}, {"miss", 0.78}}),
  };
}

}  // namespace rayproof
