/// \file
/// Faults with transforms and with solids.

#include "properties/diagnosis/cures/cures.hpp"
#include "properties/diagnosis/models/solid.hpp"
#include "properties/diagnosis/models/transform.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {

std::vector<Hypothesis> models_of_transforms() {
  return {
      gives("ignores-transform", read_as<without_transform>,
            "the answer is right without the transform: it is ignored"),
      gives("inverse-transform", read_as<with_inverse_transform>,
            "the answer is right for the inverse transform: the matrix is used where its inverse must be"),
      gives("transposed-transform", read_as<with_transposed_transform>,
            "the answer is right for the transposed matrix: rows are taken for columns"),
      gives("ignores-translation", read_as<without_translation>,
            "the answer is right without the transform's translation: it is ignored, or the origin is "
            "transformed with w = 0"),
      gives("direction-translated", read_as<direction_as_point>,
            "the direction is translated like a point: it is transformed with w = 1 and must be with w = 0"),
      gives("direction-not-transformed", read_as<direction_not_transformed>,
            "the direction is not taken into object space"),
  };
}

std::vector<Hypothesis> models_of_solids() {
  return {
      gives("radius-squared", read_as<radius_squared>, "the answer is right for the radius squared"),
      gives("radius-rooted", read_as<radius_rooted>,
            "the answer is right for the root of the radius: r is taken for r²"),
      gives("radius-doubled", read_as<radius_doubled>, "the answer is right for twice the radius"),
      gives("radius-halved", read_as<radius_halved>,
            "the answer is right for half the radius: it is taken for a diameter"),
      gives("centre-ignored", read_as<sphere_at_zero>,
            "the answer is right for a sphere at the origin of coordinates: the centre is ignored"),
      gives("centre-negated", read_as<sphere_mirrored>,
            "the answer is right for the centre's opposite: a sign is wrong in o - center"),
      gives("endless-box-x", read_as<endless_box<0>>,
            "the answer is right for a box without end along x: that slab is not tested"),
      gives("endless-box-y", read_as<endless_box<1>>,
            "the answer is right for a box without end along y: that slab is not tested"),
      gives("endless-box-z", read_as<endless_box<2>>,
            "the answer is right for a box without end along z: that slab is not tested"),
      gives("endless-edge-0", read_as<endless_parallelepiped<0>>,
            "the faces at the ends of edge 0 are not tested"),
      gives("endless-edge-1", read_as<endless_parallelepiped<1>>,
            "the faces at the ends of edge 1 are not tested"),
      gives("endless-edge-2", read_as<endless_parallelepiped<2>>,
            "the faces at the ends of edge 2 are not tested"),
      gives("parallelepiped-as-box", read_as<parallelepiped_as_box>,
            "the answer is right for the upright box between opposite corners"),
      gives("unit-edges", read_as<unit_edges>,
            "the answer is right for edges of length 1: the edges are taken for unit vectors"),
      gives("caps-added", read_as<with_caps>,
            "the answer is right for a capped cylinder: an open one has no caps"),
      gives("caps-missing", read_as<without_caps>,
            "the answer is right for an open cylinder: the caps are missing"),
      gives("lower-cap-missing", no_lower_cap, "hits on the cap at z = 0 are missing"),
      gives("upper-cap-missing", no_upper_cap, "hits on the cap at z = height are missing"),
      gives("endless-cylinder", read_as<endless_cylinder>,
            "the answer is right for a cylinder without end: the height is not tested"),
      gives("circle-rx", read_as<circular_rx>,
            "the answer is right for ry = rx: the ellipse is taken for a circle of radius rx"),
      gives("circle-ry", read_as<circular_ry>,
            "the answer is right for rx = ry: the ellipse is taken for a circle of radius ry"),
      gives("radii-exchanged", read_as<radii_exchanged>, "the answer is right with rx and ry exchanged"),
      gives("radii-squared", read_as<radii_squared>,
            "the answer is right for rx² and ry²: the radii are squared once too often"),
      gives("middle-at-zero", read_as<middle_at_zero>,
            "the answer is right for a cylinder from -height/2 to height/2"),
  };
}

}  // namespace rayproof::diagnosis
