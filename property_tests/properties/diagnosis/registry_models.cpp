/// \file
/// The registration of the models: one line each, the most specific first.

#include "properties/diagnosis/models/digits.hpp"
#include "properties/diagnosis/models/factor.hpp"
#include "properties/diagnosis/models/first_hit.hpp"
#include "properties/diagnosis/models/flat.hpp"
#include "properties/diagnosis/models/hits.hpp"
#include "properties/diagnosis/models/interval.hpp"
#include "properties/diagnosis/models/outline.hpp"
#include "properties/diagnosis/models/quadratic.hpp"
#include "properties/diagnosis/models/solid.hpp"
#include "properties/diagnosis/models/transform.hpp"
#include "properties/diagnosis/registry.hpp"

namespace rayproof::diagnosis {
namespace {

/// A subject that gives these answers.
constexpr Hypothesis gives(std::string_view name, Predict predict, std::string_view sentence,
                           FindingKind kind = FindingKind::gross, Aspect aspect = Aspect::hits) {
  return {.name = name, .kind = kind, .sentence = sentence, .aspect = aspect, .predict = predict};
}

/// A subject whose answers bear this mark.
constexpr Hypothesis shows(std::string_view name, Recognise recognise, std::string_view sentence,
                           FindingKind kind = FindingKind::gross, Aspect aspect = Aspect::hits) {
  return {.name = name, .kind = kind, .sentence = sentence, .aspect = aspect, .recognise = recognise};
}

constexpr auto boundary = FindingKind::boundary;
constexpr auto gross = FindingKind::gross;

}  // namespace

std::vector<Hypothesis> models_of_hits() {
  return {
      gives("never-hits", never_hits, "it finds nothing on any case tried"),
      gives("open-at-t-min", open_at_t_min,
            "a hit exactly at t_min is left out: the interval is taken for open there", boundary),
      gives("open-at-t-max", open_at_t_max,
            "a hit exactly at t_max is left out: the interval is taken for open there", boundary),
      gives("open-interval", open_at_both_ends,
            "hits exactly at t_min and t_max are left out: the interval is taken for open", boundary),
      gives("ignores-t-max", read_as<without_t_max>,
            "the answer is right for a ray without end: t_max is ignored"),
      gives("t-min-is-zero", t_min_is_zero, "the answer is right for t_min = 0: t_min is ignored"),
      gives("ignores-t-min", read_as<without_t_min>,
            "the answer is right without t_min: hits behind the ray's beginning are reported"),
      gives("interval-is-zero-to-inf", read_as<from_origin_on>,
            "the answer is right for the interval [0, inf]: t_min and t_max are ignored"),
      gives("whole-line", read_as<without_interval>,
            "the answer is right for the whole line: the interval of t is ignored"),
      gives("segment", read_as<as_segment>,
            "the answer is right for t in [0, 1]: the ray is taken for a segment"),
      gives("interval-as-distances", read_as<interval_as_distances>,
            "the answer is right where t_min and t_max are lengths: they are compared with distances, not "
            "with t"),
      gives("first-hit-decides", first_hit_decides,
            "it misses where the line's nearest hit lies before t_min, although a farther one lies in the "
            "interval: only the smaller root is looked at"),
      gives("misses-from-inside", misses_from_inside, "every ray that starts inside misses"),
      gives("one-hit-admits-all", one_hit_admits_all,
            "where one hit lies in the interval, the line's others are reported too: not each is compared "
            "with the interval"),
      gives("all-hits-or-none", all_hits_or_none,
            "it misses where one of the line's hits lies outside the interval, although another lies inside"),
      gives("starts-at-t-min", clipped_at_t_min,
            "a ray that starts inside is said to hit at t_min, where there is no surface"),
      gives("clipped-to-interval", clipped_to_interval,
            "where the interval ends inside the solid, its end is reported as a hit"),
      gives("farthest-hit", farthest_alone, "the farthest hit is reported in place of the nearest"),
      gives("second-hit-missing", first_alone, "of two answers only the first is given"),
      gives("descending", descending, "the answers stand in descending order"),
      gives("double-hit-twice", double_hit_twice, "a double root is reported twice", boundary),
      gives("tangent-missed", misses_at<Contact::tangent>, "a ray that only touches is missed", boundary),
      gives("edge-missed", misses_at<Contact::edge>,
            "every hit on an edge is missed: the shape is taken without its edges", boundary),
      gives("vertex-missed", misses_at<Contact::vertex>, "every hit on a vertex is missed", boundary),
      gives("rim-missed", misses_at<Contact::rim>, "every hit on a rim is missed", boundary),
      gives("boundary-outside", boundary_is_outside, "the boundary is taken for outside: the set is open",
            boundary),
      gives("boundary-inside", boundary_is_inside, "the boundary is taken for inside", boundary),
  };
}

std::vector<Hypothesis> models_of_limits() {
  return {
      gives("epsilon-1e-10", drops_below<-10>,
            "hits with t below about 1e-10 are left out: an absolute epsilon"),
      gives("epsilon-1e-9", drops_below<-9>,
            "hits with t below about 1e-9 are left out: an absolute epsilon"),
      gives("epsilon-1e-8", drops_below<-8>,
            "hits with t below about 1e-8 are left out: an absolute epsilon"),
      gives("epsilon-1e-7", drops_below<-7>,
            "hits with t below about 1e-7 are left out: an absolute epsilon"),
      gives("epsilon-1e-6", drops_below<-6>,
            "hits with t below about 1e-6 are left out: an absolute epsilon"),
      gives("epsilon-1e-5", drops_below<-5>,
            "hits with t below about 1e-5 are left out: an absolute epsilon"),
      gives("epsilon-1e-4", drops_below<-4>,
            "hits with t below about 1e-4 are left out: an absolute epsilon"),
      gives("epsilon-1e-3", drops_below<-3>,
            "hits with t below about 1e-3 are left out: an absolute epsilon"),
      gives("epsilon-1e-2", drops_below<-2>,
            "hits with t below about 1e-2 are left out: an absolute epsilon"),
      gives("limit-1e30", drops_beyond<30>,
            "hits with t beyond about 1e30 are left out: a fixed largest distance"),
      gives("limit-1e20", drops_beyond<20>,
            "hits with t beyond about 1e20 are left out: a fixed largest distance"),
      gives("limit-1e10", drops_beyond<10>,
            "hits with t beyond about 1e10 are left out: a fixed largest distance"),
      gives("limit-1e8", drops_beyond<8>,
            "hits with t beyond about 1e8 are left out: a fixed largest distance"),
      gives("limit-1e6", drops_beyond<6>,
            "hits with t beyond about 1e6 are left out: a fixed largest distance"),
      gives("limit-1e5", drops_beyond<5>,
            "hits with t beyond about 1e5 are left out: a fixed largest distance"),
      gives("limit-1e4", drops_beyond<4>,
            "hits with t beyond about 1e4 are left out: a fixed largest distance"),
      gives("limit-1e3", drops_beyond<3>,
            "hits with t beyond about 1e3 are left out: a fixed largest distance"),
      gives("limit-1e2", drops_beyond<2>,
            "hits with t beyond about 1e2 are left out: a fixed largest distance"),
  };
}

std::vector<Hypothesis> models_of_numbers() {
  return {
      gives(
          "t-as-distance", scaled_by<length_of_direction>,
          "t is right divided by the direction's length: it is a distance, not in lengths of the direction"),
      gives("t-as-object-distance", scaled_by<length_in_object>,
            "t is right divided by the length of the direction in object space: that direction was made a "
            "unit vector"),
      gives("t-over-length", scaled_by<length_of_direction, -1>,
            "t is right times the direction's length: it was divided by |d| once too often"),
      gives("t-times-square", scaled_by<square_of_direction>,
            "t is right divided by d·d: the division by d·d is missing"),
      gives("t-over-square", scaled_by<square_of_direction, -1>,
            "t is right times d·d: it was divided by d·d once too often"),
      gives("negated", scaled_by<minus_one>, "every number is right with the other sign"),
      gives("doubled", scaled_by<two>,
            "every number is twice the right one: a factor 2 in the denominator is missing"),
      gives("halved", scaled_by<two, -1>,
            "every number is half the right one: a factor 2 too many in the denominator"),
      gives("over-constant", scaled_by<constant_of_sphere, -1>,
            "t is right times c = |o - center|² - r²: the denominator is 2ac and must be 2a"),
      gives("over-radius", scaled_by<radius_of_sphere, -1>,
            "t is right times the radius: it is measured in radii"),
      gives("times-radius", scaled_by<radius_of_sphere>, "t is right divided by the radius"),
      gives("times-a", scaled_by<coefficient_a>,
            "every root is right divided by a: the division by a is missing"),
      gives("over-a", scaled_by<coefficient_a, -1>,
            "every root is right times a: a stands once too often in the denominator"),
      gives("over-c", scaled_by<coefficient_c, -1>,
            "every root is right times c: the denominator is 2ac and must be 2a"),
      gives("times-normal", scaled_by<length_of_normal>,
            "t is right divided by the normal's length: a division by it is missing"),
      gives("over-normal", scaled_by<length_of_normal, -1>,
            "t is right times the normal's length: the normal is taken for a unit vector"),
      gives("double-root-missed", double_root_missed, "a double root is taken for none", boundary),
      gives("discriminant-sign-lost", discriminant_without_sign,
            "roots are reported where D < 0: the root of |D| was taken"),
      gives("discriminant-plus", discriminant_with_plus,
            "the answer is right for D = b² + 4ac: a sign is wrong in the discriminant"),
  };
}

std::vector<Hypothesis> models_of_digits() {
  return {
      shows("computes-in-float", is_of_float,
            "every number is one of float32, though the case is of float64: the code computes in float",
            FindingKind::rounding),
      shows("prints-six-digits", has_six_digits,
            "no number has more than six digits: the code prints too few of them", FindingKind::rounding),
  };
}

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

std::vector<Hypothesis> models_of_shapes() {
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
      gives("culls-back-faces", culls_back, "a surface seen from behind is missed: back faces are culled"),
      gives("culls-front-faces", culls_front,
            "a surface seen from the front is missed: front faces are culled"),
      gives("parallelogram", read_as<as_parallelogram>,
            "the other half of the parallelogram is hit, too: u + v <= 1 is not tested"),
      gives("edge-a-not-tested", read_as<without_edge_opposite<0>>,
            "the edge bc is not tested: alpha >= 0 is missing"),
      gives("edge-b-not-tested", read_as<without_edge_opposite<1>>,
            "the edge ca is not tested: beta >= 0 is missing"),
      gives("edge-c-not-tested", read_as<without_edge_opposite<2>>,
            "the edge ab is not tested: gamma >= 0 is missing"),
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
      gives("constant-negated", read_as<constant_negated>,
            "the answer is right for -d: the plane's constant has the wrong sign"),
      gives("constant-ignored", read_as<without_constant>,
            "the answer is right for a plane through the origin of coordinates: its constant, or point, is "
            "ignored"),
      gives("constant-as-distance", read_as<constant_as_distance>,
            "the answer is right where d is a distance along a unit normal: the normal is taken for a unit "
            "vector"),
      gives("plane-parallelogram", read_as<plane_as_parallelogram>,
            "only the parallelogram of u and v is hit, and not the whole plane"),
      gives("coefficients-missing", numerator_without_coefficients,
            "t is -(x + y + z + D) / (n·d): the plane's coefficients are missing in the numerator"),
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
      gives("level-vertex", inside_by<Inside::closed_sides>,
            "a vertex level with the point counts for both of its sides or for neither: of each side one end "
            "must be open and the other closed"),
      gives("level-outside", inside_by<Inside::not_level>,
            "a point level with a vertex is taken for outside"),
      gives("winding-rule", inside_by<Inside::winding>,
            "the answer is right for the non-zero winding rule, and not for the even-odd one"),
      gives("last-side-missing", inside_by<Inside::last_side>,
            "the side from the last vertex to the first is forgotten"),
      gives("first-triangle", inside_by<Inside::first_triangle>,
            "only the first three vertices are looked at"),
      gives("taken-as-convex", inside_by<Inside::one_side>,
            "inside is where all sides turn one way: the polygon is taken for convex"),
      gives("bounding-box", inside_by<Inside::bounds>, "the whole bounding box of the polygon is hit"),
  };
}

std::vector<Hypothesis> models_of_first_hits() {
  return {
      gives("contact-parallel", in_surface_is_parallel, "a ray inside the plane is called parallel", gross,
            Aspect::contact),
      gives("no-reason", no_reason, "it does not say why the ray misses", gross, Aspect::contact),
      gives("normal-faces-ray", normal_faces_ray,
            "the normal is turned to face the ray, whatever side the surface says", gross, Aspect::normal),
      gives("normal-flipped", normal_flipped, "the normal is right with the other sign", gross,
            Aspect::normal),
      shows("normal-not-unit", normal_not_unit, "the normal's direction is right, and its length is not 1",
            gross, Aspect::normal),
      gives("normal-by-matrix", normal_by_matrix,
            "the normal is carried to the world by the matrix, and must be by its inverse transpose", gross,
            Aspect::normal),
      gives("normal-in-object", normal_in_object, "the normal is the one in object space", gross,
            Aspect::normal),
      gives("normal-from-zero", normal_from_zero,
            "the normal points from the origin of coordinates, and must from the centre", gross,
            Aspect::normal),
      shows("point-right-t-wrong", point_right_t_wrong, "the point is right although t is wrong"),
      gives("point-in-object", point_in_object, "the point is the one in object space", gross, Aspect::point),
      gives("point-without-origin", point_without_origin, "the point is t·d: the origin is missing", gross,
            Aspect::point),
      gives("point-of-far-hit", point_of_far_hit, "the point is the far hit's", gross, Aspect::point),
      gives("barycentric-acb", in_order<0, 2, 1>, "the barycentric coordinates stand in the order of a, c, b",
            gross, Aspect::coordinates),
      gives("barycentric-bac", in_order<1, 0, 2>, "the barycentric coordinates stand in the order of b, a, c",
            gross, Aspect::coordinates),
      gives("barycentric-bca", in_order<1, 2, 0>, "the barycentric coordinates stand in the order of b, c, a",
            gross, Aspect::coordinates),
      gives("barycentric-cab", in_order<2, 0, 1>, "the barycentric coordinates stand in the order of c, a, b",
            gross, Aspect::coordinates),
      gives("barycentric-cba", in_order<2, 1, 0>, "the barycentric coordinates stand in the order of c, b, a",
            gross, Aspect::coordinates),
  };
}

std::vector<Hypothesis> classes_of_cases() {
  return {
      shows("linear-not-handled", wrong_where_linear, "equations with a = 0 are not handled"),
      shows("constant-not-handled", wrong_where_constant, "equations with a = b = 0 are not handled"),
      shows("in-surface-hit", in_surface_is_hit, "a ray that runs inside the surface is reported as a hit",
            boundary),
      shows("wrong-where-concave", wrong_where_concave,
            "right on convex polygons: concave ones are not handled"),
      shows("is-nan", is_nan, "a number of the answer is NaN"),
      shows("always-hits", always_hits,
            "it finds something on every case tried, even where there is nothing"),
  };
}

}  // namespace rayproof::diagnosis
