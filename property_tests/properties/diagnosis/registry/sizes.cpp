/// \file
/// Faults of what is small and taken for 0: shapes, volumes, and components of the direction.

#include "properties/diagnosis/models/hits/components.hpp"
#include "properties/diagnosis/models/solids/parallelepiped.hpp"
#include "properties/diagnosis/models/solids/slabs.hpp"
#include "properties/diagnosis/models/space/small_shapes.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

template <int... power>
void add_small_components(std::vector<Hypothesis>& all) {
  (all.push_back(below_power(
       "small-component", power, small_components_as_zero<power>,
       "a component of the direction below about 1e{} is taken for 0: a ray nearly along a face is taken for "
       "one along it, by an absolute epsilon")),
   ...);
}

template <int... power>
void add_small_volumes(std::vector<Hypothesis>& all) {
  (all.push_back(below_power(
       "small-volume", power, small_volume_missed<power>,
       "missed where the volume of the edges, a determinant, is below about 1e{}: it is taken for 0, by "
       "an absolute epsilon")),
   ...);
}

template <int... power>
void add_flat_solids(std::vector<Hypothesis>& all) {
  (all.push_back(gives(
       kept(fmt::format("flat-solid-1e{}", power)), flat_solid_missed<power>,
       kept(fmt::format("missed where the volume of the edges is below about 1e{} of the product of their "
                        "lengths: a flat solid is taken for one without volume, by a relative epsilon",
                        power)))),
   ...);
}

/// That a size of 0 is missed alone would be less.
Hypothesis small_shape(std::string_view name, int power, Predict predict, std::string_view words) {
  return shown_by(has_some_size, below_power(name, power, predict, words));
}

template <int... power>
void add_thin_solids(std::vector<Hypothesis>& all) {
  (all.push_back(small_shape("thin-solid", power, thin_solid_missed<power>,
                             "a solid that is thinner than about 1e{} is missed, by an absolute epsilon: the "
                             "radius of a sphere, a side of a box, a radius or the height of a cylinder")),
   ...);
}

template <int... power>
void add_small_areas(std::vector<Hypothesis>& all) {
  (all.push_back(small_shape("small-area", power, small_area_missed<power>,
                             "a triangle or polygon with an area below about 1e{} is missed, by an absolute "
                             "epsilon")),
   ...);
}

template <int... power>
void add_tiny_numbers(std::vector<Hypothesis>& all) {
  (all.push_back(below_power("tiny-number", power, read_as<tiny_numbers_as_zero<power>>,
                             "the answer is right where numbers below about 1e{} are 0: they are made 0 as "
                             "they are read")),
   ...);
}

}  // namespace

std::vector<Hypothesis> models_of_tiny_numbers() {
  std::vector<Hypothesis> all;
  add_tiny_numbers<-35, -30, -20, -15, -12, -10, -9>(all);
  return all;
}

std::vector<Hypothesis> models_of_sizes() {
  std::vector<Hypothesis> all;
  add_small_components<-8, -7, -6, -5, -4, -3, -2>(all);
  add_small_volumes<-12, -10, -9, -8, -7, -6, -5, -4, -3, -2>(all);
  add_flat_solids<-8, -6, -5, -4, -3, -2, -1>(all);
  add_thin_solids<-12, -10, -9, -8, -7, -6, -5, -4, -3, -2>(all);
  return all;
}

std::vector<Hypothesis> models_of_areas() {
  std::vector<Hypothesis> all;
  add_small_areas<-12, -10, -9, -8, -7, -6, -5, -4, -3, -2>(all);
  return all;
}

}  // namespace rayproof::diagnosis
