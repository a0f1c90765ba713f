#include "generators/cylinder_aimed.hpp"
#include "generators/cylinder_shapes.hpp"
#include "generators/family.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"

namespace rayproof {

std::vector<Family> cylinder_families() {
  using namespace cylinder_family;
  const char* const topic = "cylinder";
  const MinimumShare in_reach{"in reach", 0.95};
  // The first family that breaks a property gives the counterexample: the most telling ones come first.
  return {
      family<AsLaidOut<Everyday>>(topic, {in_reach}),
      family<AsLaidOut<Far>>(topic, {in_reach}),
      family<AsLaidOut<Grazing>>(topic, {in_reach}),
      family<AsLaidOut<Rims>>(topic, {in_reach}),
      family<AsLaidOut<Caps>>(topic, {in_reach}),
      family<AsLaidOut<AxisParallel>>(topic, {in_reach}),
      family<AsLaidOut<CapPlanes>>(topic, {in_reach}),
      family<AsLaidOut<FlatEllipses>>(topic, {in_reach}),
      family<AsLaidOut<Inside>>(topic, {in_reach}),
      family<AsLaidOut<Surface>>(topic, {in_reach}),
      family<AsLaidOut<NoHeight>>(topic, {in_reach}),
      family<CutShort<Cut>>(topic, {in_reach}),
      family<Transformed<Everyday, Rims>>(topic, {in_reach}),
      family<AnySize<Everyday>>(topic, {}),
      family<Special<Cylinder<double>>>(topic, {}),
      family<BitPatterns<Cylinder<double>>>(topic, {}),
  };
}

}  // namespace rayproof
