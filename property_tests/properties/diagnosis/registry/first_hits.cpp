/// \file
/// Faults in what is said of the first hit, and classes of cases that are not handled.

#include <fmt/format.h>

#include "properties/diagnosis/models/curved/quadratic.hpp"
#include "properties/diagnosis/models/curved/shortcuts.hpp"
#include "properties/diagnosis/models/curved/small_discriminant.hpp"
#include "properties/diagnosis/models/cylinders/normals.hpp"
#include "properties/diagnosis/models/first_hit/normals.hpp"
#include "properties/diagnosis/models/first_hit/points.hpp"
#include "properties/diagnosis/models/first_hit/weights.hpp"
#include "properties/diagnosis/models/flat/flat.hpp"
#include "properties/diagnosis/models/flat/weights.hpp"
#include "properties/diagnosis/models/flat/wrong_plane.hpp"
#include "properties/diagnosis/models/hits/components.hpp"
#include "properties/diagnosis/models/hits/contacts.hpp"
#include "properties/diagnosis/models/hits/hits.hpp"
#include "properties/diagnosis/models/hits/interval.hpp"
#include "properties/diagnosis/models/hits/values.hpp"
#include "properties/diagnosis/models/outlines/outline.hpp"
#include "properties/diagnosis/models/solids/box.hpp"
#include "properties/diagnosis/models/space/details_of_shapes.hpp"
#include "properties/diagnosis/models/space/transform.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

constexpr std::string_view zero_in_words =
    "every number of the answer is 0: a product of vectors at right angles, or a variable that is never set";

constexpr std::string_view exchanged_in_words =
    "the normals of two of the three pairs of faces are exchanged";

Hypothesis given_undivided_weights() {
  Hypothesis made = gives_one_of(
      "given-undivided", given_undivided,
      "the hit is right, and beta, gamma or all three weights are given before they are divided by "
      "the determinant");
  made.aspect = Aspect::coordinates;
  return made;
}

Hypothesis of_contact(std::string_view name, Predict predict, std::string_view sentence) {
  return gives(name, predict, sentence, boundary, Aspect::contact);
}

template <int power>
Hypothesis edge_called_near() {
  return of_contact(
      kept(fmt::format("edge-called-near-1e{}", power)), called_by_weights<power>,
      kept(fmt::format("a hit is called edge, or vertex, where a barycentric coordinate is below "
                       "about 1e{}: a tolerance",
                       power)));
}

template <int power>
Hypothesis tangent_called_near() {
  return of_contact(
      kept(fmt::format("tangent-called-near-1e{}", power)), called_tangent_below<power>,
      kept(fmt::format("a hit is called tangent where the discriminant D is below about 1e{}: an "
                       "absolute tolerance on D",
                       power)));
}

template <int decimals>
Hypothesis few_decimals_of_point() {
  return shows(
      kept(fmt::format("point-decimals-{}", decimals)), point_to_decimals<decimals>,
      kept(fmt::format("the point is rounded to multiples of 1e-{}: the code prints too few decimals, "
                       "or rounds",
                       decimals)),
      gross, Aspect::point);
}

Hypothesis weights_exchanged_somewhere() {
  Hypothesis made = gives_one_of(
      "weights-exchanged-along-axis", weights_exchanged_along_axis,
      "the barycentric coordinates are exchanged where the triangle's normal is largest along one axis: in "
      "one of the projections");
  made.aspect = Aspect::coordinates;
  return made;
}

/// Under a transform rounding makes some of them other than 0.
Hypothesis missed_where_component_is_zero() {
  Hypothesis made = gives_one_of(
      "missed-without-component", missed_without_component,
      "a ray is missed where its direction has no x, or no y, or no z: a component that is 0 is not handled");
  made.admits = 40;
  return made;
}

Hypothesis normal_of_one_of(std::string_view name, Predict predict, std::string_view sentence) {
  Hypothesis made = gives_one_of(name, predict, sentence);
  made.aspect = Aspect::normal;
  return made;
}

}  // namespace

std::vector<Hypothesis> models_of_first_hits() {
  return {
      of_contact("vertex-called-edge", called<Contact::vertex, Contact::edge>,
                 "a hit at a vertex is called edge"),
      of_contact("edge-called-vertex", called<Contact::edge, Contact::vertex>,
                 "a hit on an edge is called vertex"),
      edge_called_near<-9>(),
      edge_called_near<-8>(),
      edge_called_near<-7>(),
      edge_called_near<-6>(),
      edge_called_near<-5>(),
      edge_called_near<-4>(),
      edge_called_near<-3>(),
      edge_called_near<-2>(),
      edge_called_near<-1>(),
      tangent_called_near<-9>(),
      tangent_called_near<-8>(),
      tangent_called_near<-7>(),
      tangent_called_near<-6>(),
      tangent_called_near<-5>(),
      tangent_called_near<-4>(),
      tangent_called_near<-3>(),
      tangent_called_near<-2>(),
      tangent_called_near<-1>(),
      of_contact("crossing-called-edge", called<Contact::crossing, Contact::edge>,
                 "a hit inside the shape, far from its edges, is called edge"),
      gives("contact-parallel", in_surface_is_parallel, "a ray inside the plane is called parallel", gross,
            Aspect::contact),
      gives("contacts-exchanged", reasons_exchanged,
            "a ray inside the plane is called parallel, and one parallel to it is said to be inside: the two "
            "are exchanged",
            gross, Aspect::contact),
      following("asked-again",
                gives("no-reason", no_reason, "it does not say why the ray misses", gross, Aspect::contact)),
      gives("normal-faces-ray", normal_faces_ray,
            "the normal is turned to face the ray, whatever side the surface says", gross, Aspect::normal),
      gives("normal-follows-ray", normal_follows_ray,
            "the normal is turned away from the origin of the ray, whatever side the surface says", gross,
            Aspect::normal),
      gives("normal-is-direction", normal_is_direction, "the normal is the ray's direction, reversed", gross,
            Aspect::normal),
      gives("normal-flipped", normal_flipped, "the normal is right with the other sign", gross,
            Aspect::normal),
      gives("normal-flipped-by-mirror", normal_flipped_by_mirror,
            "the normal has the wrong sign where the transform mirrors, its determinant negative: it is that "
            "of "
            "the transformed edges, or the matrix's cofactors carry it",
            gross, Aspect::normal),
      gives("normal-flipped-by-edges", normal_flipped_by_edges,
            "the normal has the wrong sign where the edges are left-handed: the sign of their determinant is "
            "left "
            "out",
            gross, Aspect::normal),
      gives(
          "normal-of-near-hit", normal_of_near_hit,
          "where the ray starts inside the normal is that of the hit behind its beginning, and must be that "
          "of the hit given",
          gross, Aspect::normal),
      gives("normal-of-other-hit", normal_of_other_hit,
            "the normals of the hits where the ray enters and where it leaves are exchanged", gross,
            Aspect::normal),
      normal_of_one_of(
          "normal-of-far-hit", normal_of_far_hit,
          "the normal is that of the far hit: always, or where the ray heads to the middle, or where "
          "it heads away"),
      shows("normal-not-unit", normal_not_unit, "the normal's direction is right, and its length is not 1",
            gross, Aspect::normal),
      gives("normal-by-matrix", normal_by_matrix,
            "the normal is carried to the world by the matrix, and must be by its inverse transpose", gross,
            Aspect::normal),
      gives("normal-by-columns", normal_by_columns,
            "the normal is right where the matrix does not shear: it is carried by the columns over the "
            "squares of their lengths, and must be by the inverse transpose",
            gross, Aspect::normal),
      gives("normal-by-inverse", normal_by_inverse,
            "the normal is carried to the world by the inverse, which must be transposed", gross,
            Aspect::normal),
      gives("normal-moved", normal_moved,
            "the normal is carried to the world as a point: the translation is added to it", gross,
            Aspect::normal),
      gives("normal-in-object", normal_in_object, "the normal is the one in object space", gross,
            Aspect::normal),
      gives("normal-from-zero", normal_from_zero,
            "the normal points from the origin of coordinates, and must from the centre", gross,
            Aspect::normal),
      gives(
          "normal-of-farthest-axis", normal_of_farthest_axis,
          "the normal is that of the face along the axis in which the point is farthest from the middle: the "
          "distance must be divided by half the box's size along that axis",
          gross, Aspect::normal),
      shows(
          "normal-signed-by-origin", normal_signed_by_origin,
          "the normal is turned round where the ray begins on the face by which it enters, or beyond it: its "
          "sign is that of the origin's side, and must be against the direction",
          gross, Aspect::normal),
      gives("normal-of-entry-axis", normal_of_entry_axis,
            "where the ray leaves the normal is along the axis of the face by which its line enters", gross,
            Aspect::normal),
      gives("normal-from-middle", normal_from_middle,
            "the normal points from the middle of the solid, as a sphere's", gross, Aspect::normal),
      gives("normal-without-signs", normal_without_signs,
            "the normal is right but for signs: none of its components is negative", gross, Aspect::normal),
      following("collinear-corner",
                gives("normal-of-first-corner", normal_of_first_corner,
                      "the normal is that of the first three vertices, which a concave corner turns round",
                      gross, Aspect::normal)),
      normal_of_one_of(
          "normal-about-mean", normal_about_mean,
          "the normal is that of two vertices and the mean of all, on which side of their side it may lie "
          "where the polygon is concave"),
      gives("normal-of-circle", normal_of_circle,
            "the normal of an elliptic cylinder is (x, y, 0), and must be (x/rx², y/ry², 0)", gross,
            Aspect::normal),
      gives("normal-by-radii", normal_by_radii,
            "the normal of an elliptic cylinder is (x/rx, y/ry, 0), and must be (x/rx², y/ry², 0)", gross,
            Aspect::normal),
      gives("cap-normals-upward", cap_normals_upward,
            "both caps' normals point upward: the lower one's must point downward", gross, Aspect::normal),
      gives("cap-normals-inward", cap_normals_inward,
            "the caps' normals point inward, and the side's outward: a sign is wrong", gross, Aspect::normal),
      gives("side-normal-faces-ray", side_normal_faces_ray,
            "the normal of the side is turned to face the ray, whatever side the surface says; those of caps "
            "are right",
            gross, Aspect::normal),
      gives("normal-keeps-z", normal_keeps_z,
            "the normal of the side keeps the z of the point, and must be level", gross, Aspect::normal),
      gives("normals-0-1", normals_exchanged<0, 1>, exchanged_in_words, gross, Aspect::normal),
      gives("normals-0-2", normals_exchanged<0, 2>, exchanged_in_words, gross, Aspect::normal),
      gives("normals-1-2", normals_exchanged<1, 2>, exchanged_in_words, gross, Aspect::normal),
      gives("normal-along-edge", normal_along_edge,
            "the normal runs along the edge that leads to the face, and must be across the other two", gross,
            Aspect::normal),
      vague(shows(
          "normal-of-other-face", normal_of_other_face,
          "the normal is another face's, or points between faces: the wrong face is taken for the one that "
          "is hit",
          gross, Aspect::normal)),
      vague(shows("point-right-t-wrong", point_right_t_wrong, "the point is right although t is wrong")),
      gives("point-in-object", point_in_object, "the point is the one in object space", gross, Aspect::point),
      gives("point-without-origin", point_without_origin, "the point is t·d: the origin is missing", gross,
            Aspect::point),
      gives("point-by-other-weights", point_by_other_weights,
            "the point is put together by the barycentric coordinates in another order", gross,
            Aspect::point),
      gives("point-by-unit-direction", point_by_unit_direction,
            "the point is o + t·d/|d|: the direction is made a unit vector for the point, and t is not of it",
            gross, Aspect::point),
      gives("point-against-direction", point_against_direction, "the point is o - t·d: a sign is wrong",
            gross, Aspect::point),
      gives("point-from-shape", point_from_shape,
            "the point is given from the shape's centre, corner or first vertex, which is not added", gross,
            Aspect::point),
      gives("point-at-foot", point_at_foot,
            "the point is the foot of the perpendicular from the ray's origin, and must be o + t·d", gross,
            Aspect::point),
      gives("point-at-radius-one", point_at_radius_one,
            "the point is the centre plus the normal, and must be plus the normal times the radius", gross,
            Aspect::point),
      gives("point-without-translation", point_without_translation,
            "the point is taken back to the world without the matrix's translation", gross, Aspect::point),
      gives("point-at-radius", point_at_radius, "the point is o + r·d, r the radius, and must be o + t·d",
            gross, Aspect::point),
      gives("point-at-direction", point_at_direction, "the point is o + d, and must be o + t·d", gross,
            Aspect::point),
      gives("point-of-far-hit", point_of_far_hit, "the point is the far hit's", gross, Aspect::point),
      few_decimals_of_point<1>(),
      few_decimals_of_point<2>(),
      few_decimals_of_point<3>(),
      few_decimals_of_point<4>(),
      few_decimals_of_point<5>(),
      few_decimals_of_point<6>(),
      shows("point-moved", point_moved_along_normal,
            "the point is moved off the surface along the normal, as an origin of the next ray is", gross,
            Aspect::point),
      shows("point-beside-ray", point_beside_ray,
            "the point does not lie on the ray's line: it is no o + t·d", gross, Aspect::point),
      gives("point-on-plane-through-mean", point_on_plane_through_mean,
            "the point lies in the plane through the mean of the vertices, which must go through the first: "
            "they need not lie in one plane",
            gross, Aspect::point),
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
      gives("barycentric-u-v-t", weights_and_t,
            "the barycentric coordinates are beta, gamma and t: alpha is missing, and t in its list", gross,
            Aspect::coordinates),
      given_undivided_weights(),
      weights_exchanged_somewhere(),
      shows("alpha-wrong", weight_is_wrong<0>, "alpha is wrong, and beta and gamma are right", gross,
            Aspect::coordinates),
      shows("beta-wrong", weight_is_wrong<1>, "beta is wrong, and alpha and gamma are right", gross,
            Aspect::coordinates),
      shows("gamma-wrong", weight_is_wrong<2>, "gamma is wrong, and alpha and beta are right", gross,
            Aspect::coordinates),
  };
}

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
      missed_where_component_is_zero(),
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
