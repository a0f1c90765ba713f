#include "generators/family.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/triangle_aimed.hpp"
#include "generators/triangle_shapes.hpp"

namespace rayproof {

std::vector<Family> triangle_families() {
  using namespace triangle_family;
  const char* const topic = "triangle";
  const MinimumShare in_reach{"in reach", 0.95};
  // The first family that breaks a property gives the counterexample: the most telling ones come first.
  return {
      family<AsLaidOut<Everyday>>(topic, {in_reach}),
      family<AsLaidOut<Edges>>(topic, {in_reach}),
      family<AsLaidOut<NearEdges>>(topic, {in_reach}),
      family<AsLaidOut<Fans>>(topic, {in_reach}),
      family<AsLaidOut<Slivers>>(topic, {in_reach}),
      family<AsLaidOut<Far>>(topic, {in_reach}),
      family<AsLaidOut<Coplanar>>(topic, {in_reach}),
      family<AsLaidOut<NearCoplanar>>(topic, {in_reach}),
      family<AsLaidOut<Degenerate>>(topic, {in_reach}),
      family<CutShort<Cut>>(topic, {in_reach}),
      family<Transformed<Everyday, Edges>>(topic, {in_reach}),
      family<AnySize<Everyday>>(topic, {}),
      family<Special<Triangle<double>>>(topic, {}),
      family<BitPatterns<Triangle<double>>>(topic, {}),
  };
}

}  // namespace rayproof
