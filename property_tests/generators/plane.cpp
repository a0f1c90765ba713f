#include "generators/family.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/plane_aimed.hpp"

namespace rayproof {

std::vector<Family> plane_families() {
  using namespace plane_family;
  const char* const topic = "plane";
  const MinimumShare in_reach{"in reach", 0.95};
  // The first family that breaks a property gives the counterexample: the most telling ones come first.
  return {
      family<AsLaidOut<Everyday>>(topic, {in_reach}),
      family<AsLaidOut<NearParallel>>(topic, {in_reach}),
      family<AsLaidOut<InPlane>>(topic, {in_reach}),
      family<AsLaidOut<Surface>>(topic, {in_reach}),
      family<AsLaidOut<Far>>(topic, {in_reach}),
      family<AsLaidOut<TinyNormal>>(topic, {in_reach}),
      family<CutShort<Cut>>(topic, {in_reach}),
      family<Transformed<Everyday, InPlane>>(topic, {in_reach}),
      family<AnySize<Everyday>>(topic, {}),
      family<Special<ImplicitPlane, PointNormalPlane, ParametricPlane>>(topic, {}),
      family<BitPatterns<ImplicitPlane, PointNormalPlane, ParametricPlane>>(topic, {}),
  };
}

}  // namespace rayproof
