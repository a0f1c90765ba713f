#include "generators/family.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/solid_aimed.hpp"
#include "generators/solid_shapes.hpp"

namespace rayproof {

namespace {

/// The families of one kind of solid. Both have the same: what is hard is where two faces meet.
template <class Kind>
std::vector<Family> solid_families(const char* topic) {
  using namespace solid_family;
  const MinimumShare in_reach{"in reach", 0.95};
  // The first family that breaks a property gives the counterexample: the most telling ones come first.
  return {
      family<AsLaidOut<Everyday<Kind>>>(topic, {in_reach}),
      family<AsLaidOut<AxisParallel<Kind>>>(topic, {in_reach}),
      family<AsLaidOut<Edges<Kind>>>(topic, {in_reach}),
      family<AsLaidOut<NearEdges<Kind>>>(topic, {in_reach}),
      family<AsLaidOut<InFaces<Kind>>>(topic, {in_reach}),
      family<AsLaidOut<Surface<Kind>>>(topic, {in_reach}),
      family<AsLaidOut<Flat<Kind>>>(topic, {in_reach}),
      family<AsLaidOut<Inside<Kind>>>(topic, {in_reach}),
      family<AsLaidOut<Far<Kind>>>(topic, {in_reach}),
      family<CutShort<Faces<Kind>>>(topic, {in_reach}),
      family<Transformed<Everyday<Kind>, Edges<Kind>>>(topic, {in_reach}),
      family<AnySize<Everyday<Kind>>>(topic, {}),
      family<Special<typename Kind::Solid>>(topic, {}),
      family<BitPatterns<typename Kind::Solid>>(topic, {}),
  };
}

}  // namespace

std::vector<Family> box_families() { return solid_families<solid_family::Boxes>("box"); }
std::vector<Family> parallelepiped_families() {
  return solid_families<solid_family::Oblique>("parallelepiped");
}

}  // namespace rayproof
