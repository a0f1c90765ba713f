#include "generators/family.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/sphere/aimed.hpp"
#include "generators/shapes/sphere/exponents.hpp"
#include "generators/shapes/sphere/sizes.hpp"
#include "generators/shapes/sphere/transformed.hpp"

namespace rayproof {

std::vector<Family> sphere_families() {
  using namespace sphere_family;
  const char* const topic = "sphere";
  const MinimumShare all_in_reach{"in reach", 1};
  // The first family that breaks a property gives the counterexample: the most telling ones come first.
  return {
      family<Far>(topic, {all_in_reach, {"hit", 0.4}, {"miss", 0.1}}),
      family<Everyday>(topic, {all_in_reach, {"hit", 0.3}, {"miss", 0.2}, {"behind", 0.05}}),
      family<Grazing>(topic, {all_in_reach, {"hit", 0.3}, {"miss", 0.2}, {"tangent", 0.05}}),
      family<Surface>(topic, {all_in_reach, {"hit", 0.3}, {"from inside", 0.2}}),
      family<Inside>(topic, {all_in_reach, {"hit", 0.99}, {"from inside", 0.99}}),
      family<Tiny>(topic, {all_in_reach, {"hit", 0.4}, {"miss", 0.1}}),
      family<Huge>(topic, {all_in_reach, {"hit", 0.4}, {"miss", 0.02}}),
      family<Cancelling>(topic, {all_in_reach, {"hit", 0.4}, {"from inside", 0.2}}),
      family<Interval>(topic, {all_in_reach, {"hit", 0.4}, {"cut", 0.2}}),
      family<Transformed<NearItsOrigin>>(topic, {all_in_reach, {"hit", 0.3}, {"miss", 0.1}}),
      family<Exponents>(topic, {{"hit", 0.1}, {"miss", 0.1}}),
      family<Special<Sphere<double>>>(topic, {{"hit", 0.02}, {"miss", 0.3}}),
      family<BitPatterns<Sphere<double>>>(topic, {{"hit", 0.02}, {"miss", 0.5}}),
  };
}

}  // namespace rayproof
