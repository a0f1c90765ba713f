/// \file
/// Faults with planes, triangles and polygons.

#include <fmt/format.h>

#include <array>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/flat/flat.hpp"
#include "properties/diagnosis/models/flat/one_sided.hpp"
#include "properties/diagnosis/models/flat/plane_end.hpp"
#include "properties/diagnosis/models/flat/small_bounds.hpp"
#include "properties/diagnosis/models/flat/tolerances.hpp"
#include "properties/diagnosis/models/flat/wrong_plane.hpp"
#include "properties/diagnosis/models/hits/starts.hpp"
#include "properties/diagnosis/models/outlines/outline.hpp"
#include "properties/diagnosis/models/plane_hit.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

template <int power>
Hypothesis loose_edges(FindingKind kind = gross) {
  return gives_one_of(
      kept(fmt::format("edges-loose-1e{}", power)), edges_with_tolerance<power>,
      kept(fmt::format("hits beside the triangle by barycentric coordinates of -1e{} count, too: a tolerance",
                       power)),
      kind);
}

template <int power>
Hypothesis tight_edges(FindingKind kind = gross) {
  // That hits on edges are left out alone would be less.
  return shown_by(
      is_hit_inside,
      of(OfSizes::small,
         gives_one_of(kept(fmt::format("edges-tight-1e{}", power)), edges_tight<power>,
                      kept(fmt::format("hits of barycentric coordinates below about 1e{} are left out: a "
                                       "tolerance of the wrong sign",
                                       power)),
                      kind)));
}

template <int power>
Hypothesis loose_areas() {
  return below_power("areas-loose", power, areas_with_tolerance<power>,
                     "hits beside the triangle count where the three areas at the point add up to 1e{} more "
                     "than the whole: an absolute tolerance");
}

template <int... power>
void add_grazing(std::vector<Hypothesis>& all) {
  (all.push_back(below_power("grazing-missed", power, grazing_missed<power>,
                             "a surface is missed at an angle below about 1e{}: a grazing ray is taken for "
                             "parallel")),
   ...);
}

template <int... power>
void add_small_slopes(std::vector<Hypothesis>& all) {
  (all.push_back(
       below_power("slope-small", power, small_slope_missed<power>,
                   "a surface is missed where |n·d|, the determinant of a triangle's formula, is below "
                   "about 1e{}: an absolute epsilon")),
   ...);
}

constexpr std::string_view signed_in_words =
    "the coordinate is left out in which the normal is largest with its sign: magnitudes must be compared";

constexpr std::string_view least_extent_in_words =
    "the coordinate is left out in which the vertices extend least, where the normal may be 0, too: it must "
    "be "
    "the one in which the normal is largest";

/// An edge that is left out on one side of the triangle: two branches for two signs of the determinant.
template <int vertex, bool is_from_behind>
Hypothesis edge_open_from() {
  constexpr std::array edges{"bc", "ca", "ab"};
  const char letter = "abc"[vertex];
  return misses_zero(
      kept(fmt::format("edge-{}-open-{}", letter, is_from_behind ? "behind" : "in-front")),
      open_at_edge_from<vertex, is_from_behind>,
      kept(fmt::format("hits on the edge {} are left out where the ray comes from {}: one of two branches "
                       "asks with > where >= belongs",
                       edges[vertex], is_from_behind ? "behind" : "in front")));
}

}  // namespace

std::vector<Hypothesis> models_of_projections() {
  return {
      gives("upright-x", upright_missed<0>,
            "a figure whose normal's x is 0 is missed: x must not be left out there, but the coordinate in "
            "which the normal is largest"),
      gives("upright-y", upright_missed<1>,
            "a figure whose normal's y is 0 is missed: y must not be left out there, but the coordinate in "
            "which the normal is largest"),
      gives("upright-z", upright_missed<2>,
            "a figure whose normal's z is 0 is missed: z must not be left out there, but the coordinate in "
            "which the normal is largest"),
      gives("upright", upright_missed<-1>,
            "a figure whose normal is 0 in a coordinate is missed: leave out the one in which the normal is "
            "largest"),
      gives(
          "projected-along-x", projected_wrongly<WrongAxis::x, true>,
          "x is left out whatever the normal, also where it is 0 along x: leave out the coordinate in which "
          "it is largest"),
      gives(
          "projected-along-y", projected_wrongly<WrongAxis::y, true>,
          "y is left out whatever the normal, also where it is 0 along y: leave out the coordinate in which "
          "it is largest"),
      gives(
          "projected-along-z", projected_wrongly<WrongAxis::z, true>,
          "z is left out whatever the normal, also where it is 0 along z: leave out the coordinate in which "
          "it is largest"),
      gives("projected-along-signed", projected_wrongly<WrongAxis::largest_signed, true>, signed_in_words),
      gives("projected-along-smallest", projected_wrongly<WrongAxis::smallest, true>,
            "the coordinate is left out in which the normal is smallest, and must be the one in which it is "
            "largest"),
      gives("projected-along-least-extent", projected_wrongly<WrongAxis::least_extent, true>,
            least_extent_in_words),
      gives("projected-along-least-extent-missed", projected_wrongly<WrongAxis::least_extent, false>,
            least_extent_in_words),
  };
}

std::vector<Hypothesis> models_of_flat_figures() {
  std::vector<Hypothesis> all{
      shown_by(
          has_small_slope<-1>,
          gives_one_of("slope-without-abs-behind", slope_without_abs<-1>,
                       "a surface is missed where -n·d, the determinant of a triangle's formula, is below a "
                       "small number, and so from behind, too: its magnitude must be compared")),
      shown_by(
          has_small_slope<1>,
          gives_one_of("slope-without-abs-in-front", slope_without_abs<1>,
                       "a surface is missed where n·d, or a determinant, is below a small number, and so "
                       "from in front, too: its magnitude must be compared")),
      gives("culls-back-faces", culls_back, "a surface seen from behind is missed: back faces are culled"),
      gives("culls-front-faces", culls_front,
            "a surface seen from the front is missed: front faces are culled"),
      gives("missed-from-front", missed_from_front,
            "a surface is missed from an origin on the side where its normal points"),
      gives("missed-from-back", missed_from_back,
            "a surface is missed from an origin on the side from which its normal points away"),
      gives_one_of("plane-ends", plane_ends,
                   "a plane is missed far from the origin of coordinates, by its coordinates there or by the "
                   "distance: it is taken for one with an end"),
      gives("triangle-constant-negated", triangle_of_wrong_constant,
            "t is right for the opposite origin, or the opposite constant, of the plane n·p = n·a: a sign is "
            "wrong in n·a - n·o"),
      gives("parallelogram", read_as<as_parallelogram>,
            "the other half of the parallelogram is hit, too: u + v <= 1 is not tested"),
      gives("edge-a-not-tested", read_as<without_edge_opposite<0>>,
            "the edge bc is not tested: alpha >= 0 is missing"),
      gives("edge-b-not-tested", read_as<without_edge_opposite<1>>,
            "the edge ca is not tested: beta >= 0 is missing"),
      gives("edge-c-not-tested", read_as<without_edge_opposite<2>>,
            "the edge ab is not tested: gamma >= 0 is missing"),
      loose_edges<-10>(boundary),
      loose_edges<-8>(boundary),
      loose_edges<-6>(boundary),
      loose_edges<-5>(),
      loose_edges<-4>(),
      loose_edges<-3>(),
      loose_edges<-2>(),
      loose_areas<-6>(),
      loose_areas<-5>(),
      loose_areas<-4>(),
      loose_areas<-3>(),
      loose_areas<-2>(),
      misses_zero("edge-a-open", open_at_edge<0>,
                  "hits on the edge bc are left out: alpha > 0 is asked, and must be alpha >= 0"),
      misses_zero("edge-b-open", open_at_edge<1>,
                  "hits on the edge ca are left out: beta > 0 is asked, and must be beta >= 0"),
      misses_zero("edge-c-open", open_at_edge<2>,
                  "hits on the edge ab are left out: gamma > 0 is asked, and must be gamma >= 0"),
      edge_open_from<0, false>(),
      edge_open_from<1, false>(),
      edge_open_from<2, false>(),
      edge_open_from<0, true>(),
      edge_open_from<1, true>(),
      edge_open_from<2, true>(),
      tight_edges<-6>(boundary),
      tight_edges<-5>(),
      tight_edges<-4>(),
      tight_edges<-3>(),
      tight_edges<-2>(),
      gives_one_of(
          "patch-of-plane", patch_of_plane,
          "a plane in the parametric form is hit only where its parameters are not large: it is taken for a "
          "patch, which ends"),
      gives("triangle-bounds", triangle_bounds,
            "the whole bounding box of the triangle is hit, as far as its plane goes"),
      gives("whole-plane", read_as<as_plane>,
            "the whole plane of the figure is hit: nothing tests whether the point is inside"),
      gives("lambda1-first-sign", wrong_sign<0>,
            "the sign of the first term of λ1 is wrong, a barycentric coordinate's in the projection"),
      gives("lambda1-second-sign", wrong_sign<1>,
            "the sign of the second term of λ1 is wrong, a barycentric coordinate's in the projection"),
      gives("lambda2-first-sign", wrong_sign<2>,
            "the sign of the first term of λ2 is wrong, a barycentric coordinate's in the projection"),
      gives("lambda2-second-sign", wrong_sign<3>,
            "the sign of the second term of λ2 is wrong, a barycentric coordinate's in the projection"),
      gives("first-corner-culls", culls_by_first_corner,
            "it misses by the normal of the first corner alone, which a concave corner turns round"),
      gives(
          "collinear-corner", plane_of_corner,
          "the plane is that of the first three vertices alone, which may lie on a line, or turn its normal "
          "round"),
      gives("edge-c-from-b", read_as<edge_from_other<2>>,
            "the answer is right for c - b in the place of the edge c - a"),
      gives("edge-b-from-c", read_as<edge_from_other<1>>,
            "the answer is right for b - c in the place of the edge b - a"),
      gives("normal-x-sign", wrong_sign_in_normal<0>,
            "the answer is right for a normal whose x has the other sign: one is wrong in the cross product"),
      gives("normal-y-sign", wrong_sign_in_normal<1>,
            "the answer is right for a normal whose y has the other sign: one is wrong in the cross product"),
      gives("normal-z-sign", wrong_sign_in_normal<2>,
            "the answer is right for a normal whose z has the other sign: one is wrong in the cross product"),
      gives_one_of(
          "small-bounding-sphere", beyond_small_sphere,
          "what its bounding sphere does not hold is missed: that is too small, as where one vertex is "
          "forgotten"),
      gives_one_of(
          "polygon-beyond-small-sphere", polygon_beyond_small_sphere,
          "a hit of a polygon is left out where it is too far from the first vertex, or from the mean "
          "of all: what is to hold the polygon, a radius by some of its vertices or sides, is too "
          "small"),
      gives_one_of("newell-wrong", newell_wrong,
                   "a sign is wrong in a component of Newell's normal, the sum of (y_i - y_j)·(z_i + z_j) "
                   "and so on"),
      gives("constant-negated", read_as<constant_negated>,
            "the answer is right for -d: the plane's constant has the wrong sign"),
      gives("constant-ignored", read_as<without_constant>,
            "the answer is right for a plane through the origin of coordinates: its constant, or point, is "
            "ignored"),
      gives("constant-as-distance", read_as<constant_as_distance>,
            "the answer is right where d is a distance along a unit normal: the normal is taken for a unit "
            "vector"),
      gives(
          "constant-without-cosine", constant_without_cosine,
          "the constant of a plane is |n||p|, the product of two lengths, and must be n·p: the cosine of the "
          "angle between them is missing"),
      gives("plane-parallelogram", read_as<plane_as_parallelogram>,
            "only the parallelogram of u and v is hit, and not the whole plane"),
      gives("figure-through-zero", plane_through_zero,
            "t is -(n·o) / (n·d): the constant n·a of the figure's plane is missing"),
      gives_one_of("normal-no-cross-product", normal_is_no_cross_product,
                   "the answer is right for a normal that is a sum of u and v, or one of them: it is u × v"),
      shows("skewed-missed", skewed_is_missed,
            "a plane is missed whose u and v are at a small angle: they are taken for dependent, by an "
            "epsilon that is too large"),
      gives_one_of("vectors-as-points", vectors_as_points,
                   "the plane's point is subtracted from u or v: these are vectors, and no points"),
      gives(
          "plane-through-mean", plane_through_mean,
          "the plane goes through the mean of the vertices, and must through the first: they need not lie in "
          "one plane"),
      gives_one_of(
          "projected-along-two-axes", projected_along_two_axes,
          "the hit's point and the vertices are not projected along the same axis: of one of them the same "
          "coordinate is always left out, of the other that in which the normal is largest"),
      gives("coefficients-missing", numerator_without_coefficients,
            "t is -(x + y + z + D) / (n·d): the plane's coefficients are missing in the numerator"),
      gives("flat-bounds-missed", flat_bounds_missed,
            "a figure in a plane along an axis is missed: its bounding box has no thickness there"),
      gives("projected-along-signed-missed", projected_wrongly<WrongAxis::largest_signed, false>,
            signed_in_words),
  };
  add_grazing<-2, -3, -4, -5, -6, -8, -12>(all);
  all.push_back(of(
      OfSizes::small,
      gives("slope-type-epsilon", slope_below_epsilon_missed,
            "a surface is missed where |n·d|, the determinant of a triangle's formula, is below the machine "
            "epsilon of the type, 1.2e-7 or 2.2e-16: it is no measure of that")));
  all.back().differs_by_precision = true;
  add_small_slopes<-16, -15, -14, -13, -12, -10, -9, -8, -7>(all);
  all.push_back(of(
      OfSizes::small,
      gives("slope-float-epsilon", slope_below_float_epsilon_missed,
            "a surface is missed where |n·d|, the determinant of a triangle's formula, is below the machine "
            "epsilon of float, 1.2e-7, in doubles, too: it is no measure of that")));
  add_small_slopes<-6, -5, -4, -3, -2>(all);
  return all;
}

}  // namespace rayproof::diagnosis
