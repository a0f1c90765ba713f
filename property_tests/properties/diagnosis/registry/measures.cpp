/// \file
/// Faults of one size: a factor, or a length that is added, which is measured.

#include "properties/diagnosis/models/hits/measures.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {

std::vector<Hypothesis> models_of_sizes_measured() {
  return {
      has_one_factor("radius-times", factor_of_radius,
                     "the answer is right for a sphere whose radius is multiplied by a factor",
                     with_radius_times),
      has_one_size("radius-plus", added_to_radius,
                   "the answer is right for a sphere whose radius is longer, or shorter, by a fixed length",
                   with_radius_plus),
      has_one_factor("numbers-times", factor_of<Bears::both>,
                     "every number of the answer is multiplied by a fixed factor"),
      has_one_factor("first-times", factor_of<Bears::first>,
                     "of two numbers the first is multiplied by a fixed factor, and the second is right"),
      has_one_factor("second-times", factor_of<Bears::second>,
                     "of two numbers the second is multiplied by a fixed factor, and the first is right"),
      has_one_size("numbers-plus", added_to_numbers, "to every number of the answer a fixed one is added"),
      has_one_size("lengths-plus", added_in_lengths,
                   "every hit lies behind the right one by a fixed length, or before it where that is "
                   "negative"),
  };
}

}  // namespace rayproof::diagnosis
