/// \file
/// Faults in the first hit's normal.

#include "properties/diagnosis/models/cylinders/normals.hpp"
#include "properties/diagnosis/models/first_hit/normals.hpp"
#include "properties/diagnosis/models/solids/box.hpp"
#include "properties/diagnosis/models/space/details_of_shapes.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

constexpr std::string_view exchanged_in_words =
    "the normals of two of the three pairs of faces are exchanged";

}  // namespace

std::vector<Hypothesis> models_of_normals() {
  return {
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
            "of the transformed edges, or the matrix's cofactors carry it",
            gross, Aspect::normal),
      gives("normal-flipped-by-edges", normal_flipped_by_edges,
            "the normal has the wrong sign where the edges are left-handed: the sign of their determinant is "
            "left out",
            gross, Aspect::normal),
      gives(
          "normal-of-near-hit", normal_of_near_hit,
          "where the ray starts inside the normal is that of the hit behind its beginning, and must be that "
          "of the hit given",
          gross, Aspect::normal),
      gives("normal-of-other-hit", normal_of_other_hit,
            "the normals of the hits where the ray enters and where it leaves are exchanged", gross,
            Aspect::normal),
      gives_one_of(
          "normal-of-far-hit", normal_of_far_hit,
          "the normal is that of the far hit: always, or where the ray heads to the middle, or where "
          "it heads away",
          gross, Aspect::normal),
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
      gives_one_of(
          "normal-about-mean", normal_about_mean,
          "the normal is that of two vertices and the mean of all, on which side of their side it may "
          "lie where the polygon is concave",
          gross, Aspect::normal),
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
  };
}

}  // namespace rayproof::diagnosis
