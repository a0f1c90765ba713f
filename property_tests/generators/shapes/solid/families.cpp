#include "generators/family.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/solid/aimed.hpp"
#include "generators/shapes/solid/shapes.hpp"

namespace rayproof {

namespace {

/// The families of one kind of solid. Both have the same: what is hard is where two faces meet. `flat` is
/// what the flat ones must produce, of which only a box may have no thickness at all.
template <class Kind>
std::vector<Family> solid_families(const char* topic, const std::vector<MinimumShare>& flat) {
  using namespace solid_family;
  const MinimumShare in_reach{"in reach", 0.95};
  // The first family that breaks a property gives the counterexample: the most telling ones come first.
  return {
      family<AsLaidOut<Everyday<Kind>>>(topic, {in_reach, {"hit", 0.39}, {"miss", 0.43}, {"behind", 0.05}}),
      family<AsLaidOut<AxisParallel<Kind>>>(topic,
                                            {in_reach, {"hit", 0.4}, {"miss", 0.37}, {"sharp", 0.004}}),
      family<AsLaidOut<Edges<Kind>>>(topic, {in_reach, {"hit", 0.95}, {"tangent", 0.32}, {"sharp", 0.74}}),
      family<AsLaidOut<NearEdges<Kind>>>(topic, {in_reach, {"hit", 0.57}, {"miss", 0.24}}),
      family<AsLaidOut<InFaces<Kind>>>(
          topic, {in_reach, {"hit", 0.42}, {"miss", 0.41}, {"tangent", 0.03}, {"sharp", 0.52}}),
      family<AsLaidOut<Surface<Kind>>>(
          topic,
          {in_reach, {"hit", 0.67}, {"tangent", 0.21}, {"sharp", 0.3}, {"cut", 0.24}, {"from inside", 0.03}}),
      family<AsLaidOut<Flat<Kind>>>(topic, flat),
      family<AsLaidOut<Inside<Kind>>>(topic, {in_reach, {"hit", 0.95}, {"cut", 0.95}, {"from inside", 0.95}}),
      family<AsLaidOut<Far<Kind>>>(topic, {in_reach, {"hit", 0.74}, {"miss", 0.1}}),
      family<CutShort<Faces<Kind>>>(topic, {in_reach,
                                            {"hit", 0.65},
                                            {"miss", 0.18},
                                            {"tangent", 0.09},
                                            {"sharp", 0.25},
                                            {"behind", 0.18},
                                            {"cut", 0.38}}),
      family<Transformed<Everyday<Kind>, Edges<Kind>>>(
          topic, {in_reach, {"hit", 0.54}, {"miss", 0.29}, {"tangent", 0.11}, {"sharp", 0.25}}),
      family<AnySize<Everyday<Kind>>>(topic, {{"hit", 0.39}, {"miss", 0.43}, {"behind", 0.05}}),
      family<Special<typename Kind::Solid>>(topic, {{"hit", 0.03}, {"miss", 0.77}}),
      family<BitPatterns<typename Kind::Solid>>(topic, {{"hit", 0.03}, {"miss", 0.78}}),
  };
}

}  // namespace

std::vector<Family> box_families() {
  return solid_families<solid_family::Boxes>(
      "box", {{"in reach", 0.95}, {"hit", 0.4}, {"miss", 0.4}, {"sharp", 0.15}, {"tangent", 0.12}});
}
std::vector<Family> parallelepiped_families() {
  return solid_families<solid_family::Oblique>("parallelepiped",
                                               {{"in reach", 0.95}, {"hit", 0.6}, {"miss", 0.15}});
}

}  // namespace rayproof
