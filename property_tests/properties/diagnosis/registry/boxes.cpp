/// \file
/// The faults of boxes: their corners, and rays through edges.

#include "properties/diagnosis/models/solids/box.hpp"
#include "properties/diagnosis/models/solids/edges.hpp"
#include "properties/diagnosis/models/solids/rounded_box.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

/// A search along the ray, as by distances, that ends at a fixed length before the surface.
template <int power>
Hypothesis stops_before_by() {
  // A search may end on the surface, too.
  return admitting(
      60,
      of(OfSizes::small,
         shows(kept(fmt::format("stops-before-1e{}", power)), stops_before<power>,
               kept(fmt::format("hits lie before the surface by up to 1e{}, or beside it, whatever the "
                                "scene's size: a search along the ray ends there, by an absolute tolerance",
                                power)))));
}

}  // namespace

std::vector<Hypothesis> models_of_corners() {
  return {
      gives("max-as-half-size", read_as<max_as_half_size>,
            "the answer is right for a box from -max to max: max is taken for half the size"),
      gives("sides-as-x", read_as<sides_alike<0>>,
            "the answer is right for a cube from min: all sides are as long as that along x"),
      gives("sides-as-y", read_as<sides_alike<1>>,
            "the answer is right for a cube from min: all sides are as long as that along y"),
      gives("sides-as-z", read_as<sides_alike<2>>,
            "the answer is right for a cube from min: all sides are as long as that along z"),
      gives("sides-as-longest", read_as<sides_as_longest>,
            "the answer is right for a cube from min: all sides are as long as the longest"),
      of(OfSizes::type, gives("middle-in-float", read_as<middle_in_float>,
                              "the answer is right for the box whose middle and half size are floats, though "
                              "the case is of float64",
                              rounding)),
      gives("max-x-y", corner_exchanged<&Box<double>::max, 0, 1>,
            "the answer is right with x and y of max exchanged"),
      gives("max-x-z", corner_exchanged<&Box<double>::max, 0, 2>,
            "the answer is right with x and z of max exchanged"),
      gives("max-y-z", corner_exchanged<&Box<double>::max, 1, 2>,
            "the answer is right with y and z of max exchanged"),
      gives("min-x-y", corner_exchanged<&Box<double>::min, 0, 1>,
            "the answer is right with x and y of min exchanged"),
      gives("min-x-z", corner_exchanged<&Box<double>::min, 0, 2>,
            "the answer is right with x and z of min exchanged"),
      gives("min-y-z", corner_exchanged<&Box<double>::min, 1, 2>,
            "the answer is right with y and z of min exchanged"),
      gives("max-y-for-x", corner_copied<&Box<double>::max, 1, 0>,
            "the answer is right with y of max in the place of its x"),
      gives("max-z-for-x", corner_copied<&Box<double>::max, 2, 0>,
            "the answer is right with z of max in the place of its x"),
      gives("max-x-for-y", corner_copied<&Box<double>::max, 0, 1>,
            "the answer is right with x of max in the place of its y"),
      gives("max-z-for-y", corner_copied<&Box<double>::max, 2, 1>,
            "the answer is right with z of max in the place of its y"),
      gives("max-x-for-z", corner_copied<&Box<double>::max, 0, 2>,
            "the answer is right with x of max in the place of its z"),
      gives("max-y-for-z", corner_copied<&Box<double>::max, 1, 2>,
            "the answer is right with y of max in the place of its z"),
      gives("min-y-for-x", corner_copied<&Box<double>::min, 1, 0>,
            "the answer is right with y of min in the place of its x"),
      gives("min-z-for-x", corner_copied<&Box<double>::min, 2, 0>,
            "the answer is right with z of min in the place of its x"),
      gives("min-x-for-y", corner_copied<&Box<double>::min, 0, 1>,
            "the answer is right with x of min in the place of its y"),
      gives("min-z-for-y", corner_copied<&Box<double>::min, 2, 1>,
            "the answer is right with z of min in the place of its y"),
      gives("min-x-for-z", corner_copied<&Box<double>::min, 0, 2>,
            "the answer is right with x of min in the place of its z"),
      gives("min-y-for-z", corner_copied<&Box<double>::min, 1, 2>,
            "the answer is right with y of min in the place of its z"),
  };
}

std::vector<Hypothesis> models_of_edges() {
  return {
      shows("rounded-edges", has_rounded_edges,
            "the edges and corners of a box, or a cylinder's rims, are rounded off: a smaller solid is met, "
            "with a margin around it"),
      stops_before_by<-6>(),
      stops_before_by<-5>(),
      stops_before_by<-4>(),
      stops_before_by<-3>(),
      stops_before_by<-2>(),
      shows("rounded-centre", is_of_rounded_centre,
            "right for the box whose centre and half lengths, or sizes, or its place beside the ray's "
            "origin, are rounded: far from the origin of coordinates, or beside a long side, these lose the "
            "digits of min and max",
            rounding),
      shows(
          "missed-through-edge", missed_through_edge,
          "a ray that enters the solid through an edge, or a rim, is missed: rounding puts the point beside "
          "either face",
          boundary),
  };
}

}  // namespace rayproof::diagnosis
