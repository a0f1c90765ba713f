/// \file
/// Faults with the slabs of solids, with their widths, and with rays along a cylinder's axis.

#include "properties/diagnosis/models/solids/slabs.hpp"

#include <fmt/format.h>

#include "properties/diagnosis/models/cylinders/ends.hpp"
#include "properties/diagnosis/models/hits/wrong_interval.hpp"
#include "properties/diagnosis/models/solids/loose.hpp"
#include "properties/diagnosis/models/solids/solid_mistakes.hpp"
#include "properties/diagnosis/models/space/small_shapes.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

/// A solid that is larger, or smaller, by a fixed length: in a larger scene that is next to nothing.
template <int... power>
void add_loose(std::vector<Hypothesis>& all) {
  (all.push_back(
       below_power("solid-wider", power, read_as<widened_by<power>>,
                   "the answer is right for a solid that is wider by 1e{} at each end: a tolerance")),
   ...);
  (all.push_back(below_power(
       "solid-narrower", power, narrowed_by<power>,
       "the answer is right for a solid that is narrower by 1e{} at each end: an absolute epsilon keeps its "
       "ends out")),
   ...);
}

template <int... power>
void add_thickened(std::vector<Hypothesis>& all) {
  (all.push_back(
       of(OfSizes::small,
          gives_one_of(
              kept(fmt::format("thickened-1e{}", power)), thickened_to<power>,
              kept(fmt::format("a box that is thinner than 1e{} is made as thick, and hit where it is not",
                               power))))),
   ...);
}

template <int... power>
void add_along_axis(std::vector<Hypothesis>& all) {
  (all.push_back(below_power(
       "side-missed-along", power, side_missed_along<power>,
       "the side is missed where dx² + dy² is below about 1e{}: a ray nearly along the axis is taken for one "
       "along it, by an absolute epsilon")),
   ...);
}

/// That 0 alone is made as large many another fault would do.
Hypothesis raised_component(int power, Predict predict,
                            bool (*shows_more)(const Case& one, const Answer& exact)) {
  return shown_by(shows_more,
                  below_power("raised-component", power, predict,
                              "the answer is right where each component of the direction below 1e{}, 0 "
                              "too, is made as large: so that "
                              "nothing is divided by 0, and the ray runs askew"));
}

template <int... power>
void add_raised_components(std::vector<Hypothesis>& all) {
  (all.push_back(raised_component(power, read_as<components_raised<power>>, has_component_below<power>)),
   ...);
}

/// That what lies beyond is missed would be a limit of t: a part of a solid must be hit.
template <int... power>
void add_cuts(std::vector<Hypothesis>& all) {
  const auto cut = [](int tens, Predict predict, bool (*shows_more)(const Case&, const Answer&)) {
    return of(OfSizes::limit,
              shown_by(shows_more, gives(kept(fmt::format("slabs-cut-1e{}", tens)), predict,
                                         kept(fmt::format("a solid is cut off where |t| is about 1e{}: its "
                                                          "slabs begin with that number in place of infinity",
                                                          tens)))));
  };
  (all.push_back(cut(power, cut_at<power>, has_hit_on_cut<power>)), ...);
}

template <unsigned axis>
void add_slab_order(std::vector<Hypothesis>& all, char coordinate) {
  all.push_back(
      gives(kept(fmt::format("slab-exchanged-{}", coordinate)), slabs_exchanged<1U << axis>,
            kept(fmt::format("near and far are exchanged in the slab of {}: min and max of its two t",
                             coordinate))));
  all.push_back(
      gives(kept(fmt::format("slab-unsorted-{}", coordinate)), slabs_unsorted<1U << axis>,
            kept(fmt::format("near and far are not exchanged in the slab of {} where the direction's "
                             "component is negative",
                             coordinate))));
}

}  // namespace

std::vector<Hypothesis> models_of_axis_rays() {
  std::vector<Hypothesis> all;
  add_along_axis<-12, -10, -8, -6, -4, -3>(all);
  return all;
}

std::vector<Hypothesis> models_of_slab_orders() {
  std::vector<Hypothesis> all{
      gives("slabs-unsorted", slabs_unsorted<7U>,
            "near and far slab are not exchanged where a component of the direction is negative")};
  add_slab_order<0>(all, 'x');
  add_slab_order<1>(all, 'y');
  add_slab_order<2>(all, 'z');
  all.push_back(gives_one_of("slab-divided-by-other", slab_divided_by_other,
                             "the t of a slab are divided by the direction's component along another axis"));
  all.push_back(
      gives("exit-beyond-end-missed", exit_beyond_end_missed,
            "a ray is said to miss where it leaves the solid beyond t_max, though it enters before"));
  all.push_back(gives("slab-ends-in-else", slab_ends_in_else,
                      "a slab's end is compared only where its beginning was not taken, or the other way "
                      "round: an else stands between the two, and both must be asked"));
  all.push_back(
      gives("sum-of-coordinates-tested", sum_of_coordinates_tested,
            "the answer is right for the tetrahedron of corner and edges: u + v + w <= 1 is asked, and "
            "must not be"));
  all.push_back(gives_one_of("one-by-transposed", one_by_transposed,
                             "of origin and direction one goes into the edges' frame by the transposed "
                             "matrix: rows are taken for columns"));
  add_cuts<30, 20, 12, 10, 9, 8, 7, 6, 5, 4, 3, 2>(all);
  add_raised_components<-12, -10, -9, -8, -7, -6, -5, -4, -3, -2>(all);
  add_loose<-8, -7, -6, -5, -4, -3, -2>(all);
  add_thickened<-8, -7, -6, -5, -4, -3, -2, -1>(all);
  return all;
}

}  // namespace rayproof::diagnosis
