#include "properties/diagnosis/registry.hpp"

namespace rayproof {

std::string_view name_without_limit(const Hypothesis& cause) {
  const std::string_view stem = stem_of_limit(cause.name);
  return stem.empty() ? cause.name : stem;
}

const std::vector<HypothesisTable>& hypothesis_tables() {
  using namespace diagnosis;
  static const std::vector<HypothesisTable> all{
      {"Every case answered alike", models_of_all_alike()},
      {"Projections of flat figures", models_of_projections()},
      {"Rays along the axis of a cylinder", models_of_axis_rays()},
      {"Interval and list of hits", models_of_hits()},
      {"Limits", models_of_limits()},
      {"Thin solids and small directions", models_of_sizes()},
      {"Units and digits of t", models_of_numbers()},
      {"Cylinders", models_of_cylinders()},
      {"The formula for two roots", models_of_roots()},
      {"Coefficients and discriminants", models_of_coefficients()},
      {"Transforms", models_of_transforms()},
      {"Spheres, boxes and parallelepipeds", models_of_solids()},
      {"Corners of boxes", models_of_corners()},
      {"Slabs", models_of_slab_orders()},
      {"Edges of solids", models_of_edges()},
      {"Planes and triangles", models_of_flat_figures()},
      {"Small areas", models_of_areas()},
      {"Points in polygons", models_of_outlines()},
      {"Points in triangles and faces", models_of_weights()},
      {"Numbers of a case that are read otherwise", models_of_readings()},
      {"Tiny numbers", models_of_tiny_numbers()},
      {"Sizes that are measured", models_of_sizes_measured()},
      {"How a hit is named", models_of_contacts()},
      {"Normals", models_of_normals()},
      {"Points and coordinates of a hit", models_of_points()},
      {"Digits", models_of_digits()},
      {"Roots", classes_of_roots()},
      {"One cure", cures_of_values()},
      {"Cases that are not handled", classes_of_cases()},
      {"Boundaries and rounding", cures_of_boundaries()},
      {"Two cures at once", pairs_of_cures()}};
  return all;
}

const std::vector<Hypothesis>& hypotheses() {
  static const std::vector<Hypothesis> all = [] {
    std::vector<Hypothesis> gathered;
    for (const HypothesisTable& table : hypothesis_tables())
      gathered.insert(gathered.end(), table.lines.begin(), table.lines.end());
    return gathered;
  }();
  return all;
}

const Hypothesis* find_hypothesis(std::string_view name) {
  for (const Hypothesis& one : hypotheses())
    if (one.name == name) return &one;
  return nullptr;
}

}  // namespace rayproof
