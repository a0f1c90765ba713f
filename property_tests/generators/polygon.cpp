#include "generators/family.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/polygon_lifted.hpp"

namespace rayproof {

std::vector<Family> polygon_families() {
  using namespace polygon_family;
  namespace layout = outline_layout;
  const char* const topic = "polygon";
  const MinimumShare in_reach{"in reach", 0.95};
  // The first family that breaks a property gives the counterexample: the most telling ones come first.
  return {
      family<AsLaidOut<Lifted<layout::Level>>>(topic, {in_reach}),
      family<AsLaidOut<Everyday>>(topic, {in_reach}),
      family<AsLaidOut<Lifted<layout::Boundary>>>(topic, {in_reach}),
      family<AsLaidOut<Lifted<layout::NearBoundary>>>(topic, {in_reach}),
      family<AsLaidOut<Lifted<layout::Crossing>>>(topic, {in_reach}),
      family<AsLaidOut<Lifted<layout::Repeated>>>(topic, {in_reach}),
      family<AsLaidOut<Lifted<layout::NoArea>>>(topic, {in_reach}),
      family<AsLaidOut<Coplanar>>(topic, {in_reach}),
      family<AsLaidOut<FarOff>>(topic, {in_reach}),
      family<CutShort<Cut>>(topic, {in_reach}),
      family<Transformed<Everyday, Lifted<layout::Boundary>>>(topic, {in_reach}),
      family<AnySize<Everyday>>(topic, {}),
      family<Special<Polygon<double>>>(topic, {}),
      family<BitPatterns<Polygon<double>>>(topic, {}),
  };
}

}  // namespace rayproof
