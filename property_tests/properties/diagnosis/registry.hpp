#pragma once
/// \file
/// The tables that make the registry of hypotheses.

#include "properties/diagnosis/hypothesis.hpp"

namespace rayproof::diagnosis {

/// @{ Each hypothesis is one line of one of these.
[[nodiscard]] std::vector<Hypothesis> models_of_all_alike();
[[nodiscard]] std::vector<Hypothesis> models_of_hits();
[[nodiscard]] std::vector<Hypothesis> models_of_limits();
[[nodiscard]] std::vector<Hypothesis> models_of_numbers();
[[nodiscard]] std::vector<Hypothesis> models_of_roots();
[[nodiscard]] std::vector<Hypothesis> models_of_coefficients();
[[nodiscard]] std::vector<Hypothesis> classes_of_roots();
[[nodiscard]] std::vector<Hypothesis> models_of_tiny_numbers();
[[nodiscard]] std::vector<Hypothesis> models_of_transforms();
[[nodiscard]] std::vector<Hypothesis> models_of_solids();
[[nodiscard]] std::vector<Hypothesis> models_of_corners();
[[nodiscard]] std::vector<Hypothesis> models_of_axis_rays();
[[nodiscard]] std::vector<Hypothesis> models_of_slab_orders();
[[nodiscard]] std::vector<Hypothesis> models_of_sizes();
[[nodiscard]] std::vector<Hypothesis> models_of_areas();
[[nodiscard]] std::vector<Hypothesis> models_of_weights();
[[nodiscard]] std::vector<Hypothesis> models_of_projections();
[[nodiscard]] std::vector<Hypothesis> models_of_cylinders();
[[nodiscard]] std::vector<Hypothesis> models_of_edges();
[[nodiscard]] std::vector<Hypothesis> models_of_flat_figures();
[[nodiscard]] std::vector<Hypothesis> models_of_outlines();
[[nodiscard]] std::vector<Hypothesis> models_of_readings();
[[nodiscard]] std::vector<Hypothesis> models_of_contacts();
[[nodiscard]] std::vector<Hypothesis> models_of_normals();
[[nodiscard]] std::vector<Hypothesis> models_of_points();
[[nodiscard]] std::vector<Hypothesis> models_of_sizes_measured();
[[nodiscard]] std::vector<Hypothesis> models_of_digits();
[[nodiscard]] std::vector<Hypothesis> cures_of_values();
[[nodiscard]] std::vector<Hypothesis> classes_of_cases();
[[nodiscard]] std::vector<Hypothesis> cures_of_boundaries();
[[nodiscard]] std::vector<Hypothesis> pairs_of_cures();
/// @}

}  // namespace rayproof::diagnosis
