#include "generators/family.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/disk/scenes.hpp"

namespace rayproof {

std::vector<Family> disk_families() {
  using namespace disk_family;
  const char* const topic = "disk";
  const MinimumShare in_reach{"in reach", 0.95};
  // The first family that breaks a property gives the counterexample: the most telling ones come first.
  return {
      family<AsLaidOut<Everyday>>(topic, {in_reach, {"hit", 0.4}, {"miss", 0.3}}),
      family<AsLaidOut<Rim>>(topic,
                             {in_reach, {"hit", 0.42}, {"miss", 0.3}, {"rim", 0.3}, {"in surface", 0.02}}),
      family<AsLaidOut<NearRim>>(topic, {in_reach, {"hit", 0.3}, {"miss", 0.3}}),
      family<CutShort<Rim>>(topic, {in_reach, {"hit", 0.3}, {"miss", 0.3}, {"rim", 0.15}}),
      family<Transformed<Everyday, Rim>>(topic, {in_reach, {"hit", 0.4}, {"miss", 0.3}, {"rim", 0.08}}),
      family<AnySize<Everyday>>(topic, {{"hit", 0.4}, {"miss", 0.3}}),
      family<Special<Disk<double>>>(topic, {{"hit", 0.03}, {"miss", 0.6}}),
      family<BitPatterns<Disk<double>>>(topic, {{"hit", 0.05}, {"miss", 0.6}}),
  };
}

}  // namespace rayproof
