#include "properties/diagnosis/registry.hpp"

namespace rayproof {

const std::vector<Hypothesis>& hypotheses() {
  using namespace diagnosis;
  static const std::vector<Hypothesis> all = [] {
    std::vector<Hypothesis> gathered;
    for (const auto table :
         {models_of_projections,  models_of_axis_rays, models_of_hits,        models_of_limits,
          models_of_numbers,      models_of_cylinders, models_of_roots,       models_of_transforms,
          models_of_solids,       models_of_corners,   models_of_slab_orders, models_of_edges,
          models_of_flat_figures, models_of_outlines,  models_of_weights,     models_of_readings,
          models_of_first_hits,   models_of_digits,    classes_of_roots,      cures_of_values,
          classes_of_cases,       cures_of_boundaries, pairs_of_cures})
      for (const Hypothesis& one : table()) gathered.push_back(one);
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
