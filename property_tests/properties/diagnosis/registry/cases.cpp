/// \file
/// Classes of cases that are not handled, and of answers that are no answers.

#include "properties/diagnosis/models/curved/quadratic.hpp"
#include "properties/diagnosis/models/curved/shortcuts.hpp"
#include "properties/diagnosis/models/flat/flat.hpp"
#include "properties/diagnosis/models/hits/components.hpp"
#include "properties/diagnosis/models/hits/contacts.hpp"
#include "properties/diagnosis/models/hits/hits.hpp"
#include "properties/diagnosis/models/hits/interval.hpp"
#include "properties/diagnosis/models/hits/values.hpp"
#include "properties/diagnosis/models/outlines/outline.hpp"
#include "properties/diagnosis/models/space/transform.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

constexpr std::string_view zero_in_words =
    "every number of the answer is 0: a product of vectors at right angles, or a variable that is never set";

constexpr std::string_view without_component_in_words =
    "a ray is missed where its direction has no x, or no y, or no z: a component that is 0 is not handled";

}  // namespace

std::vector<Hypothesis> classes_of_cases() {
  return {
      shows("linear-not-handled", wrong_where_linear, "equations with a = 0 are not handled"),
      shows("no-constant-not-handled", wrong_where_c_is_zero,
            "equations with c = 0, which have a root 0, are not handled"),
      shows("no-linear-term-not-handled", wrong_where_b_is_zero, "equations with b = 0 are not handled"),
      shows("sum-zero-not-handled", wrong_where_sum_is_zero,
            "equations with a + b + c = 0, which have a root 1, are not handled"),
      shows("square-alone-not-handled", wrong_where_square, "equations ax² = 0 are not handled"),
      shows("everything-not-handled", wrong_where_all_is_zero, "the equation 0 = 0 is not handled", boundary),
      following("linear-not-handled", shows("constant-not-handled", wrong_where_constant,
                                            "equations with a = b = 0 are not handled")),
      // Under a transform rounding makes some components other than 0.
      admitting(
          40, gives_one_of("missed-without-component", missed_without_component, without_component_in_words)),
      strictly(
          gives("mirrored-missed", mirrored_missed,
                "what a matrix mirrors is missed: its determinant is negative, and is taken for too small")),
      following("asked-again",
                shows("parallel-hit", parallel_is_hit,
                      "a ray along the plane, parallel to it or inside it, is reported as a hit")),
      shows("no-area-hit", no_area_is_hit,
            "a figure without area is reported as a hit: its normal is 0, and must be asked for"),
      shows("zero-slope-hit", zero_slope_is_hit,
            "a ray along the plane, or a figure without area, is reported as a hit: a division by 0 is not "
            "kept from"),
      shows("in-surface-hit", in_surface_is_hit, "a ray that runs inside the surface is reported as a hit",
            boundary),
      vague(shows(
          "wrong-where-upright", wrong_where_upright,
          "right on polygons whose normal is 0 in no coordinate: leave out the one in which its magnitude is "
          "largest")),
      vague(shows("wrong-where-concave", wrong_where_concave,
                  "right on convex polygons: concave ones are not handled")),
      following("whole-line", vague(shows("hits-before-t-min", hits_before_t_min,
                                          "hits before t_min are reported: t_min is ignored"))),
      shows("is-nan", is_nan, "a number of the answer is NaN"),
      gives("t-is-zero", all_at_zero, zero_in_words),
      shows("is-zero", is_all_zero, zero_in_words),
      vague(shows("is-infinite", is_infinite,
                  "a number of the answer is infinite: a division by 0 is not kept from")),
      of_no_hits(strictly(gives("never-hits", never_hits,
                                "every case tried misses, says the subject: nothing is ever found"))),
      shows("roots-not-sorted", not_sorted<Quadratic<double>>,
            "the roots are right, and do not always stand in ascending order: they are not sorted"),
  };
}

}  // namespace rayproof::diagnosis
