/// \file
/// Faults with transforms and with solids.

#include "properties/diagnosis/cures/cures.hpp"
#include "properties/diagnosis/models/box.hpp"
#include "properties/diagnosis/models/caps.hpp"
#include "properties/diagnosis/models/cylinder.hpp"
#include "properties/diagnosis/models/edges.hpp"
#include "properties/diagnosis/models/faces.hpp"
#include "properties/diagnosis/models/placing.hpp"
#include "properties/diagnosis/models/side.hpp"
#include "properties/diagnosis/models/slabs.hpp"
#include "properties/diagnosis/models/solid.hpp"
#include "properties/diagnosis/models/transform.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {

std::vector<Hypothesis> models_of_transforms() {
  return {
      gives("ignores-transform", read_as<without_transform>,
            "the answer is right without the transform: it is ignored"),
      gives("ignores-translation", read_as<without_translation>,
            "the answer is right without the transform's translation: it is ignored, or the origin is "
            "transformed with w = 0"),
      of(OfSizes::small,
         gives("small-determinant-1e-8", small_determinant_missed<-8>,
               "what a matrix of a determinant below 1e-8 places is missed: it is taken for singular")),
      of(OfSizes::small,
         gives("small-determinant-1e-6", small_determinant_missed<-6>,
               "what a matrix of a determinant below 1e-6 places is missed: it is taken for singular")),
      of(OfSizes::small,
         gives("small-determinant-1e-4", small_determinant_missed<-4>,
               "what a matrix of a determinant below 1e-4 places is missed: it is taken for singular")),
      gives("inverse-transform", read_as<with_inverse_transform>,
            "the answer is right for the inverse transform: the matrix is used where its inverse must be"),
      gives("origin-not-transformed", read_as<origin_not_transformed>,
            "the origin is not taken into object space"),
      gives("transposed-transform", read_as<with_transposed_transform>,
            "the answer is right for the transposed matrix: rows are taken for columns"),
      gives("direction-translated", read_as<direction_as_point>,
            "the direction is translated like a point: it is transformed with w = 1 and must be with w = 0"),
      gives("direction-not-transformed", read_as<direction_not_transformed>,
            "the direction is not taken into object space"),
      gives("transpose-as-inverse", read_as<with_transpose_for_inverse>,
            "the matrix's transpose is taken for its inverse"),
      gives("uniform-scale", read_as<with_uniform_scale>,
            "the answer is right for a sphere in the world: the transform is taken for one that scales all "
            "axes alike"),
      gives("bounds-in-world", read_as<bounds_in_world>,
            "the answer is right for the upright bounding box in the world"),
      gives("two-corners-in-world", read_as<between_two_corners>,
            "the answer is right for the upright box between min and max in the world: no other corner is "
            "transformed"),
      gives("corner-not-moved", read_as<corner_not_moved>,
            "the edges are taken to the world, and the corner is not"),
      gives("edges-translated", read_as<edges_translated>,
            "the edges are taken to the world like points: they are translated, too"),
      gives(
          "bounding-sphere-too-small", beyond_bounding_sphere,
          "what its bounding sphere does not hold is missed: its radius is made longer by the longest column "
          "of the matrix, which is too little where the matrix shears"),
  };
}

std::vector<Hypothesis> models_of_solids() {
  return {
      gives("radius-squared", read_as<radius_squared>, "the answer is right for the radius squared"),
      gives("radius-rooted", radius_for_square,
            "the answer is right for the root of the radius: r is taken for r²"),
      gives("radius-square-added", radius_square_added,
            "it finds nothing on any case tried: no hit is looked for, or c = |o - center|² + r², the sign "
            "of r² wrong"),
      gives("radius-doubled", read_as<radius_doubled>, "the answer is right for twice the radius"),
      gives("radius-halved", read_as<radius_halved>,
            "the answer is right for half the radius: it is taken for a diameter"),
      gives("radius-one", read_as<radius_one>,
            "the answer is right for a radius of 1: the radius is ignored"),
      gives("centre-ignored", read_as<sphere_at_zero>,
            "the answer is right for a sphere at the origin of coordinates: the centre is ignored"),
      gives("centre-negated", read_as<sphere_mirrored>,
            "the answer is right for the centre's opposite: a sign is wrong in o - center"),
      gives("discriminant-of-sphere", sphere_without_sign,
            "hits are reported where D < 0: the root of |D| was taken, or D < 0 is not tested"),
      gives("nearest-point", nearest_point_of_line,
            "t is the line's nearest point to the centre: ±√D is left out"),
      gives("half-chord", half_chord,
            "t is half the chord: the line's nearest point to the centre is left out"),
      gives(
          "centre-behind-missed", centre_behind_missed,
          "a sphere whose centre lies behind the ray's beginning is missed, although the ray starts inside"),
      misses_zero("point-missed", sphere_of_no_radius_missed,
                  "a sphere of radius 0 is missed: it is a point, and a ray may meet it"),
      misses_zero("flat-box-missed", flat_box_missed, "a box without thickness along an axis is missed"),
      gives("max-as-size", read_as<max_as_size>,
            "the answer is right for a box from min to min + max: max is taken for the size"),
      gives(
          "size-as-half", read_as<size_as_half>,
          "the answer is right for a box twice as large about its middle: the size is taken for half of it"),
      gives("sum-as-middle", read_as<sum_as_middle>,
            "the answer is right for a box about min + max: the sum is taken for the middle, and must be "
            "halved"),
      gives("slabs-without-signs", slabs_without_signs,
            "the t of the slabs are taken without their signs: |t| is compared"),
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
      gives("half-endless-edge-0", read_as<half_endless_parallelepiped<0>>,
            "the face at the end of edge 0 is not tested: the edge is taken for an endless half line"),
      gives("half-endless-edge-1", read_as<half_endless_parallelepiped<1>>,
            "the face at the end of edge 1 is not tested: the edge is taken for an endless half line"),
      gives("half-endless-edge-2", read_as<half_endless_parallelepiped<2>>,
            "the face at the end of edge 2 is not tested: the edge is taken for an endless half line"),
      gives(
          "slab-along-not-tested", slab_along_not_tested,
          "a ray along a slab is not compared with it: where the direction's component is 0 the origin must "
          "lie between the two planes"),
      misses_zero(
          "missed-in-low-face", missed_in_face<true, false>,
          "a ray in the plane of a face at min, or at the corner, is missed: > is asked there, and must "
          "be >="),
      misses_zero(
          "missed-in-high-face", missed_in_face<false, true>,
          "a ray in the plane of a face at max, or opposite to the corner, is missed: < is asked there, "
          "and must be <="),
      gives("missed-in-face", missed_in_face<true, true>,
            "a ray in the plane of a face is missed: 0·∞ is no number, or an inequality is strict there"),
      gives("missed-along-slab", missed_along_slab,
            "every ray along a face is missed: a component of the direction that is 0 is taken for a miss"),
      gives("leaves-at-last-end", leaves_at_last_end,
            "the line is taken to leave where it leaves the last of the slabs, and must leave with the "
            "first: max "
            "for min"),
      gives("enters-at-first-beginning", enters_at_first_beginning,
            "the line is taken to enter where it enters the first of the slabs, and must enter with the "
            "last: min "
            "for max"),
      gives("leaves-before-it-enters", leaves_before_it_enters,
            "a line that leaves one slab before it enters another is said to hit: the two are not compared"),
      gives("corner-faces-alone", corner_faces_alone,
            "only the three faces at min, or at the corner, are hit: the opposite ones are missing"),
      gives("parallelepiped-as-box", read_as<parallelepiped_as_box>,
            "the answer is right for the upright box between opposite corners"),
      gives("parallelepiped-as-bounds", read_as<parallelepiped_as_bounds>,
            "the answer is right for the upright bounding box"),
      gives("edges-times-length", read_as<edges_times_length>,
            "the answer is right for each edge times its length: coordinates that are counted in edges are "
            "compared with lengths, and must be with 1"),
      gives("edges-as-orthogonal", read_as<edges_as_orthogonal>,
            "the answer is right where a point's coordinates are its projections on the edges: the edges are "
            "taken for orthogonal, a rectangular solid's"),
      gives("faces-as-rectangles", by_faces<rectangular_face>,
            "a face is hit where the point's projections on its two edges lie between their ends: the faces "
            "are "
            "taken for rectangles"),
      gives("corner-as-centre", read_as<corner_as_centre>,
            "the answer is right for a solid centred at the corner: the corner is taken for the centre"),
      gives("edges-transposed", read_as<edges_transposed>,
            "the answer is right for the transposed matrix of the edges: rows are taken for columns"),
      gives("unit-edges", read_as<unit_edges>,
            "the answer is right for edges of length 1: the edges are taken for unit vectors"),
  };
}

std::vector<Hypothesis> models_of_cylinders() {
  return {
      gives("caps-added", read_as<with_caps>,
            "the answer is right for a capped cylinder: an open one has no caps"),
      gives("caps-missing", read_as<without_caps>,
            "the answer is right for an open cylinder: the caps are missing"),
      gives("caps-without-rim", caps_without_rim,
            "the whole plane of a cap is hit: (x/rx)² + (y/ry)² <= 1 is not tested there"),
      gives("caps-as-rectangles", caps_as_rectangles,
            "the caps are taken for rectangles: (x/rx)² + (y/ry)² <= 1 is not tested there"),
      gives("lower-cap-missing", no_lower_cap, "hits on the cap at z = 0 are missing"),
      gives("upper-cap-missing", no_upper_cap, "hits on the cap at z = height are missing"),
      gives("caps-of-radius-rx", caps_of_radius_rx,
            "the caps are circles of radius rx, and must be ellipses as the side is"),
      gives("caps-of-radius-ry", caps_of_radius_ry,
            "the caps are circles of radius ry, and must be ellipses as the side is"),
      gives("caps-of-rooted-radius", caps_of_rooted_radius,
            "a cap is hit where x² + y² <= r, and must be where x² + y² <= r²"),
      gives("caps-from-outside-alone", caps_from_outside_alone,
            "a cap is hit from outside alone: a ray that leaves through it does not hit it"),
      gives("side-before-caps", side_before_caps,
            "a hit on the side is reported even where one on a cap is nearer"),
      gives("endless-cylinder", read_as<endless_cylinder>,
            "the answer is right for a cylinder without end: the height is not tested"),
      gives("upper-end-not-tested", upper_end_not_tested,
            "the upper end of the cylinder is not tested: z <= height is missing"),
      gives("lower-end-not-tested", lower_end_not_tested,
            "the lower end of the cylinder is not tested: z >= 0 is missing"),
      gives("first-side-hit-decides", first_side_hit_decides,
            "it misses where the side's first hit lies beyond an end, although the other one is on the "
            "cylinder"),
      gives(
          "smaller-side-root", smaller_side_root_alone,
          "of the side's two roots the smaller one alone is looked at: the inside of the wall is never hit"),
      gives("larger-side-root", larger_side_root_alone,
            "of the side's two roots the larger one alone is looked at: the side is never hit from outside"),
      gives("first-side-root", first_side_root_alone,
            "of the side's hits only the first in the interval is looked at, and no other is reported"),
      gives("side-without-ends", side_without_ends,
            "the side goes on beyond the caps: the height is not tested there, neither below nor above"),
      gives("caps-where-side-missed", caps_where_side_missed,
            "the caps are hit only where the side is not hit at all: a ray may pass through both"),
      misses_zero("low-rim-missed", without_low_rim, "hits on the rim at z = 0 are left out: z > 0 is asked"),
      misses_zero("high-rim-missed", without_high_rim,
                  "hits on the rim at z = height are left out: z < height is asked"),
      misses_zero("rims-missed", without_rims,
                  "hits on both rims are left out: the height is taken for open"),
      gives("cylinder-as-box", read_as<cylinder_as_box>,
            "the answer is right for the box round the cylinder: the caps are rectangles"),
      gives("circle-rx", read_as<circular_rx>,
            "the answer is right for ry = rx: the ellipse is taken for a circle of radius rx"),
      gives("circle-ry", read_as<circular_ry>,
            "the answer is right for rx = ry: the ellipse is taken for a circle of radius ry"),
      gives("radii-exchanged", read_as<radii_exchanged>, "the answer is right with rx and ry exchanged"),
      gives("radii-squared", read_as<radii_squared>,
            "the answer is right for rx² and ry²: the radii are squared once too often"),
      gives("radii-rooted", read_as<radii_rooted>,
            "the answer is right for the roots of the radii: r is taken for r²"),
      gives("missed-along-axis", missed_along_axis,
            "every ray along the axis is missed, also where it hits a cap"),
      gives("radii-doubled", read_as<radii_doubled>, "the answer is right for twice the radii"),
      gives("radii-halved", read_as<radii_halved>,
            "the answer is right for half the radii: they are taken for diameters"),
      gives("radii-mean", read_as<radii_mean>,
            "the answer is right for a circle of the mean of rx and ry: the ellipse is taken for a circle"),
      gives("height-doubled", read_as<height_doubled>, "the answer is right for twice the height"),
      gives("height-halved", read_as<height_halved>, "the answer is right for half the height"),
      gives("radii-one", read_as<radii_one>, "the answer is right for radii of 1: they are ignored"),
      gives("height-one", read_as<height_one>, "the answer is right for a height of 1: it is ignored"),
      gives("axis-is-x", read_as<cylinder_along<0>>, "the answer is right for a cylinder along x"),
      gives("axis-is-y", read_as<cylinder_along<1>>, "the answer is right for a cylinder along y"),
      gives("axis-turned-to-x", read_as<cylinder_turned_to<0>>,
            "the answer is right for a cylinder along x, its radii along y and z"),
      gives("axis-turned-to-y", read_as<cylinder_turned_to<1>>,
            "the answer is right for a cylinder along y, its radii along z and x"),
      gives("middle-at-zero", read_as<middle_at_zero>,
            "the answer is right for a cylinder from -height/2 to height/2"),
  };
}

std::vector<Hypothesis> models_of_edges() {
  return {
      shows("rounded-edges", has_rounded_edges,
            "the edges and corners of a box are rounded off: a smaller box is met, with a margin around it"),
      shows("rounded-centre", is_of_rounded_centre,
            "right for the box whose centre and half lengths, or sizes, are rounded: far from the origin of "
            "coordinates, or beside a long side, these lose the digits of min and max",
            rounding),
      shows(
          "missed-through-edge", missed_through_edge,
          "a ray that enters the solid through an edge, or a rim, is missed: rounding puts the point beside "
          "either face",
          boundary),
  };
}

}  // namespace rayproof::diagnosis
