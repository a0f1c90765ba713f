#include "generators/family.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/plane/aimed.hpp"

namespace rayproof {

std::vector<Family> plane_families() {
  using namespace plane_family;
  const char* const topic = "plane";
  const MinimumShare in_reach{"in reach", 0.95};
  // The first family that breaks a property gives the counterexample: the most telling ones come first.
  return {
      family<AsLaidOut<Everyday>>(topic, {in_reach, {"hit", 0.61}, {"miss", 0.23}, {"behind", 0.23}}),
      family<AsLaidOut<NearParallel>>(topic, {in_reach, {"hit", 0.42}, {"miss", 0.42}}),
      family<AsLaidOut<InPlane>>(topic, {in_reach, {"miss", 0.95}, {"in surface", 0.61}, {"parallel", 0.23}}),
      family<AsLaidOut<Surface>>(topic, {in_reach, {"hit", 0.56}, {"miss", 0.27}}),
      family<AsLaidOut<Far>>(topic, {in_reach, {"hit", 0.95}}),
      family<AsLaidOut<TinyNormal>>(topic, {in_reach, {"hit", 0.95}}),
      family<CutShort<Cut>>(topic,
                            {in_reach, {"hit", 0.49}, {"miss", 0.35}, {"in surface", 0.03}, {"behind", 0.3}}),
      family<Transformed<Everyday, InPlane>>(
          topic, {in_reach, {"hit", 0.41}, {"miss", 0.43}, {"in surface", 0.21}, {"parallel", 0.06}}),
      family<AnySize<Everyday>>(topic, {{"hit", 0.61}, {"miss", 0.23}, {"behind", 0.23}}),
      family<Special<ImplicitPlane, PointNormalPlane, ParametricPlane>>(topic,
                                                                        {{"hit", 0.35}, {"miss", 0.49}}),
      family<BitPatterns<ImplicitPlane, PointNormalPlane, ParametricPlane>>(topic,
                                                                            {{"hit", 0.38}, {"miss", 0.46}}),
  };
}

}  // namespace rayproof
