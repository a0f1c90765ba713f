#include "generators/family.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/triangle/aimed.hpp"
#include "generators/shapes/triangle/shapes.hpp"

namespace rayproof {

std::vector<Family> triangle_families() {
  using namespace triangle_family;
  const char* const topic = "triangle";
  const MinimumShare in_reach{"in reach", 0.95};
  // The first family that breaks a property gives the counterexample: the most telling ones come first.
  return {
      family<AsLaidOut<Everyday>>(topic, {in_reach, {"hit", 0.38}, {"miss", 0.46}, {"behind", 0.05}}),
      family<AsLaidOut<Edges>>(topic, {in_reach, {"hit", 0.83}, {"edge", 0.48}, {"vertex", 0.35}}),
      family<AsLaidOut<NearEdges>>(topic, {in_reach, {"hit", 0.33}, {"miss", 0.51}}),
      family<AsLaidOut<Fans>>(topic, {in_reach,
                                      {"hit", 0.76},
                                      {"miss", 0.08},
                                      {"edge", 0.29},
                                      {"vertex", 0.47},
                                      {"in surface", 0.04},
                                      {"degenerate", 0.02}}),
      family<AsLaidOut<Upright>>(topic, {in_reach, {"hit", 0.8}, {"edge", 0.3}}),
      family<AsLaidOut<Slivers>>(topic, {in_reach, {"hit", 0.44}, {"miss", 0.4}}),
      family<AsLaidOut<Far>>(topic, {in_reach, {"hit", 0.38}, {"miss", 0.45}}),
      family<AsLaidOut<Coplanar>>(topic,
                                  {in_reach, {"miss", 0.95}, {"in surface", 0.57}, {"parallel", 0.27}}),
      family<AsLaidOut<NearCoplanar>>(topic, {in_reach, {"hit", 0.43}, {"miss", 0.41}}),
      family<AsLaidOut<Degenerate>>(
          topic, {in_reach, {"hit", 0.04}, {"miss", 0.77}, {"vertex", 0.03}, {"degenerate", 0.64}}),
      family<CutShort<Cut>>(topic,
                            {in_reach, {"hit", 0.47}, {"miss", 0.34}, {"edge", 0.14}, {"behind", 0.34}}),
      family<Transformed<Everyday, Edges>>(
          topic, {in_reach, {"hit", 0.54}, {"miss", 0.3}, {"edge", 0.15}, {"vertex", 0.12}}),
      family<AnySize<Everyday>>(topic, {{"hit", 0.38}, {"miss", 0.46}, {"behind", 0.05}}),
      family<Special<Triangle<double>>>(topic, {{"hit", 0.03}, {"miss", 0.8}}),
      family<BitPatterns<Triangle<double>>>(topic, {{"hit", 0.04}, {"miss", 0.79}}),
  };
}

}  // namespace rayproof
