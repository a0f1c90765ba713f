/// \file
/// Faults with transforms.

#include "properties/diagnosis/models/space/placing.hpp"
#include "properties/diagnosis/models/space/transform.hpp"
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
      gives("translation-negated", read_as<translation_negated>,
            "the answer is right for the opposite translation: it is added to the origin on the way into "
            "object "
            "space, and must be subtracted"),
      gives("translation-undone-last", read_as<translation_undone_last>,
            "the origin is taken into object space by the inverse matrix first, and the translation is "
            "subtracted then: it must be subtracted first"),
      gives("direction-translated", read_as<direction_as_point>,
            "the direction is translated like a point: it is transformed with w = 1 and must be with w = 0"),
      gives("direction-not-transformed", read_as<direction_not_transformed>,
            "the direction is not taken into object space"),
      gives("direction-by-matrix", read_as<direction_by_matrix>,
            "the direction is taken into object space by the matrix, and must be by its inverse"),
      gives("origin-by-matrix", read_as<origin_by_matrix>,
            "the origin is taken into object space by the matrix, and must be by its inverse"),
      gives("inverse-undivided", read_as<inverse_undivided>,
            "the inverse is not divided by the matrix's determinant"),
      gives("diagonal-alone", read_as<diagonal_alone>,
            "of the matrix the diagonal alone is looked at, as if it scaled along the axes: what it turns or "
            "shears is left out"),
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
      gives("plane-normal-by-matrix", read_as<plane_normal_by_matrix>,
            "the plane's normal is carried to the world by the matrix, and must be by its inverse transpose"),
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

}  // namespace rayproof::diagnosis
