/// \file
/// Faults with spheres, boxes and parallelepipeds.

#include "properties/diagnosis/cures/cures.hpp"
#include "properties/diagnosis/models/curved/coefficients.hpp"
#include "properties/diagnosis/models/curved/wrong_chord.hpp"
#include "properties/diagnosis/models/flat/one_sided.hpp"
#include "properties/diagnosis/models/solids/box.hpp"
#include "properties/diagnosis/models/solids/faces.hpp"
#include "properties/diagnosis/models/solids/parallelepiped.hpp"
#include "properties/diagnosis/models/solids/slab_arithmetic.hpp"
#include "properties/diagnosis/models/solids/slabs.hpp"
#include "properties/diagnosis/models/solids/small_sphere.hpp"
#include "properties/diagnosis/models/solids/solid.hpp"
#include "properties/diagnosis/models/solids/wrong_slabs.hpp"
#include "properties/diagnosis/models/space/details_of_shapes.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
std::vector<Hypothesis> models_of_solids() {
  return {
      gives("radius-squared", read_as<radius_squared>, "the answer is right for the radius squared"),
      gives("radius-doubled-for-square", radius_for_square<2>, "2r is taken for r²"),
      gives("radius-rooted", radius_for_square<1>,
            "the answer is right for the root of the radius: r is taken for r²"),
      of_no_hits(
          gives("radius-square-added", radius_square_added,
                "every ray misses, says the subject: nothing is ever hit; no hit is looked for, or c = |o - "
                "center|² + r², the sign of r² wrong")),
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
          "t-from-scaled-origin", t_from_scaled_origin,
          "t is the distance of the hit from (o - center) / r: the origin was overwritten by the one in the "
          "unit sphere's space"),
      gives("half-chord-by-difference", half_chord_by_difference,
            "half of the chord is r - d, d the distance of the centre from the line, and must be √(r² - d²)"),
      gives_one_of(
          "half-chord-as-radius", half_chord_as_radius,
          "half of the chord is taken for the radius, or for 1, however far the line passes from the "
          "centre, and must be √(r² - d²): every line is said to hit"),
      shown_by(
          starts_outside_of_sphere,
          gives_one_of("near-hits-of-sphere-missed", near_hits_of_sphere_missed,
                       "hits nearer to the ray's origin than the radius, or twice that, are left out, or a "
                       "sphere whose surface is nearer than the direction's length: against hits of the "
                       "surface just left, and too far")),
      gives_one_of(
          "square-beside-radius", square_beside_radius,
          "missed where the square of the line's distance from the middle is larger than the radius, "
          "of the sphere or of one round the solid: it must be compared with the radius squared"),
      gives_one_of(
          "solid-beyond-small-sphere", solid_beyond_small_sphere,
          "what the sphere round it does not hold is missed: that is too small, its radius half of an "
          "edge, and must be half of the diagonal"),
      gives(
          "centre-behind-missed", centre_behind_missed,
          "a sphere whose centre lies behind the ray's beginning is missed, although the ray starts inside"),
      shown_by(has_no_linear_term,
               gives_one_of("zero-coefficient-missed", missed_with_zero_coefficient,
                            "a sphere is missed where b = 0, or where b or c is 0, in a·t² + b·t + c: the "
                            "origin is the point of the line nearest to the centre, or lies on the sphere")),
      // Else every direction is taken for a unit vector.
      of_share(90, gives_one_of("a-as-one-by-length", a_as_one_by_length,
                                "the direction is taken for a unit vector where it is shorter than 1, or "
                                "longer")),
      gives_one_of(
          "centre-beyond-missed", centre_beyond_missed,
          "a sphere whose centre is farther away than t_max is missed, although its surface is nearer"),
      misses_zero("point-missed", sphere_of_no_radius_missed,
                  "a sphere of radius 0 is missed: it is a point, and a ray may meet it"),
      misses_zero("flat-box-missed", flat_box_missed, "a box without thickness along an axis is missed"),
      gives("max-as-size", read_as<max_as_size>,
            "the answer is right for a box from min to min + max: max is taken for the size"),
      gives(
          "size-as-half", read_as<size_as_half>,
          "the answer is right for a box twice as large about its middle: the size is taken for half of it"),
      gives("half-as-size", read_as<half_as_size>,
            "the answer is right for a box half as large about its middle: half the size is halved again"),
      gives("sum-as-middle", read_as<sum_as_middle>,
            "the answer is right for a box about min + max: the sum is taken for the middle, and must be "
            "halved"),
      gives("zero-size-as-one", read_as<zero_size_as_one>,
            "the answer is right for 1 where a radius, or the height, is 0: 0 is taken for a number that is "
            "not given"),
      gives("slabs-without-signs", slabs_without_signs,
            "the t of the slabs are taken without their signs: |t| is compared"),
      gives("slabs-upside-down", slabs_upside_down,
            "the t of the slabs are upside down: d stands over the way to the plane, and must be under it"),
      gives("slabs-turned-by-origin", slabs_turned_by_origin,
            "near and far of a slab are exchanged by the sign of the origin's coordinate, and must be by "
            "that of "
            "the direction's"),
      gives("first-slab-alone", first_slab_alone,
            "only the first slab that the ray crosses is looked at: the loop ends there"),
      gives_one_of("missed-from-beyond", missed_from_beyond,
                   "a ray from beyond a face is missed, whatever its direction: an early test looks at the "
                   "origin alone"),
      gives("endless-box-x", without_slab<0>,
            "the answer is right for a box without end along x: that slab is not tested"),
      gives("endless-box-y", without_slab<1>,
            "the answer is right for a box without end along y: that slab is not tested"),
      gives("endless-box-z", without_slab<2>,
            "the answer is right for a box without end along z: that slab is not tested"),
      gives("endless-edge-0", without_faces_of_edge<0>, "the faces at the ends of edge 0 are not tested"),
      gives("endless-edge-1", without_faces_of_edge<1>, "the faces at the ends of edge 1 are not tested"),
      gives("endless-edge-2", without_faces_of_edge<2>, "the faces at the ends of edge 2 are not tested"),
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
          "be >=, or 0·∞ is no number there"),
      misses_zero(
          "missed-in-high-face", missed_in_face<false, true>,
          "a ray in the plane of a face at max, or opposite to the corner, is missed: < is asked there, "
          "and must be <=, or 0·∞ is no number there"),
      gives("missed-in-face", missed_in_face<true, true>,
            "a ray in the plane of a face is missed: 0·∞ is no number, or an inequality is strict there"),
      // A few that are hit, as those in the middle of what is compared with the wrong sign, refute it.
      admitting(3, gives("missed-along-slab", missed_along_slab,
                         "every ray along a face is missed: a component of the direction that is 0 is taken "
                         "for a miss")),
      gives("slab-along-mirrored", slab_along_mirrored,
            "of a slab that the ray runs along the origin is compared with the wrong sign"),
      gives_one_of("nan-in-slab", nan_in_slab,
                   "0·∞ is NaN in the slab of a face that the ray runs in, of which no comparison is true: "
                   "the slab is not looked at, or what was found of the others is lost"),
      gives_one_of("stops-at-parallel-slab", stops_at_parallel_slab,
                   "the slabs that come after one which the ray runs along are not looked at: the loop "
                   "must go on"),
      of(OfSizes::type, gives("reciprocal-in-float", reciprocal_in_float,
                              "1/d is a float, though the case is of float64: it has seven digits, and is 0 "
                              "or infinite where d is large or small",
                              rounding)),
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
      gives(
          "zero-pivot-missed", zero_pivot_missed,
          "missed where the first edge has x = 0, or the next pivot is 0: an elimination must exchange rows"),
      shown_by(
          has_small_volume,
          gives_one_of("volume-without-abs", volume_without_abs,
                       "missed where the volume of the edges, a determinant, is below a small number, and so "
                       "where they are left-handed, too: its magnitude must be compared")),
      gives("left-handed-missed", left_handed_missed,
            "a solid whose edges are left-handed, their determinant negative, is missed"),
      gives("missed-beside-two-corners", missed_beside_two_corners,
            "missed beside the upright box between the corner and the opposite one: it is taken for the "
            "bounds, and the other corners may lie outside of it"),
      gives("parallelepiped-as-bounds", read_as<parallelepiped_as_bounds>,
            "the answer is right for the upright bounding box"),
      gives("edges-times-length", read_as<edges_times_length>,
            "the answer is right for each edge times its length: coordinates that are counted in edges are "
            "compared with lengths, and must be with 1"),
      gives_one_of("edge-of-other-length", edge_of_other_length,
                   "the answer is right with one of the edges twice, or half, as long"),
      gives("edges-along-axes", read_as<edges_along_axes>,
            "the answer is right for an upright box from the corner, as long, deep and high as the edges are "
            "long: their directions are ignored"),
      gives("edges-as-orthogonal", read_as<edges_as_orthogonal>,
            "the answer is right where a point's coordinates are its projections on the edges: the edges are "
            "taken for orthogonal, a rectangular solid's"),
      gives("faces-as-rectangles", by_faces<rectangular_face>,
            "a face is hit where the point's projections on its two edges lie between their ends: the faces "
            "are "
            "taken for rectangles"),
      gives("corner-as-centre", read_as<corner_as_centre>,
            "the answer is right for a solid centred at the corner: the corner is taken for the centre"),
      gives("edges-as-vertices", read_as<edges_as_vertices>,
            "the answer is right where the edges are vertices: the corner is subtracted from each of them"),
      gives("diagonal-0-1", read_as<diagonal_for_edge<0, 1>>,
            "the answer is right with edge 1 added to edge 0: a face's diagonal is taken for an edge"),
      gives("diagonal-0-2", read_as<diagonal_for_edge<0, 2>>,
            "the answer is right with edge 2 added to edge 0: a face's diagonal is taken for an edge"),
      gives("diagonal-1-0", read_as<diagonal_for_edge<1, 0>>,
            "the answer is right with edge 0 added to edge 1: a face's diagonal is taken for an edge"),
      gives("diagonal-1-2", read_as<diagonal_for_edge<1, 2>>,
            "the answer is right with edge 2 added to edge 1: a face's diagonal is taken for an edge"),
      gives("diagonal-2-0", read_as<diagonal_for_edge<2, 0>>,
            "the answer is right with edge 0 added to edge 2: a face's diagonal is taken for an edge"),
      gives("diagonal-2-1", read_as<diagonal_for_edge<2, 1>>,
            "the answer is right with edge 1 added to edge 2: a face's diagonal is taken for an edge"),
      gives("edges-transposed", read_as<edges_transposed>,
            "the answer is right for the transposed matrix of the edges: rows are taken for columns"),
      gives("unit-edges", read_as<unit_edges>,
            "the answer is right for edges of length 1: the edges are taken for unit vectors"),
  };
}

}  // namespace rayproof::diagnosis
