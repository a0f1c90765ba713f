#include "generators/family.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/polygon/lifted.hpp"

namespace rayproof {

std::vector<Family> polygon_families() {
  using namespace polygon_family;
  namespace layout = outline_layout;
  const char* const topic = "polygon";
  const MinimumShare in_reach{"in reach", 0.95};
  // The first family that breaks a property gives the counterexample: the most telling ones come first.
  return {
      family<AsLaidOut<Lifted<layout::Level>>>(
          topic, {in_reach, {"hit", 0.44}, {"miss", 0.4}, {"edge", 0.16}, {"vertex", 0.14}}),
      family<AsLaidOut<Everyday>>(topic, {in_reach, {"hit", 0.39}, {"miss", 0.45}, {"behind", 0.06}}),
      family<AsLaidOut<Lifted<layout::Boundary>>>(
          topic, {in_reach, {"hit", 0.83}, {"edge", 0.51}, {"vertex", 0.32}}),
      family<AsLaidOut<Lifted<layout::NearBoundary>>>(topic, {in_reach, {"hit", 0.38}, {"miss", 0.45}}),
      family<AsLaidOut<Lifted<layout::Crossing>>>(topic, {in_reach, {"hit", 0.3}, {"miss", 0.54}}),
      family<AsLaidOut<Lifted<layout::Repeated>>>(
          topic,
          {in_reach, {"hit", 0.16}, {"miss", 0.68}, {"edge", 0.04}, {"vertex", 0.012}, {"degenerate", 0.03}}),
      family<AsLaidOut<Lifted<layout::NoArea>>>(topic, {in_reach, {"miss", 0.95}, {"degenerate", 0.95}}),
      family<AsLaidOut<Coplanar>>(topic,
                                  {in_reach, {"miss", 0.95}, {"in surface", 0.62}, {"parallel", 0.21}}),
      family<AsLaidOut<FarOff>>(topic, {in_reach, {"hit", 0.42}, {"miss", 0.42}}),
      family<CutShort<Cut>>(
          topic, {in_reach, {"hit", 0.37}, {"miss", 0.46}, {"edge", 0.18}, {"vertex", 0.1}, {"behind", 0.2}}),
      family<Transformed<Everyday, Lifted<layout::Boundary>>>(
          topic, {in_reach, {"hit", 0.54}, {"miss", 0.3}, {"edge", 0.18}, {"vertex", 0.1}}),
      family<AnySize<Everyday>>(topic, {{"hit", 0.39}, {"miss", 0.45}, {"behind", 0.06}}),
      family<Special<Polygon<double>>>(topic, {{"hit", 0.04}, {"miss", 0.79}}),
      family<BitPatterns<Polygon<double>>>(topic, {{"hit", 0.05}, {"miss", 0.78}}),
  };
}

}  // namespace rayproof
