/// \file
/// Faults in the first hit's point and barycentric coordinates.

#include <fmt/format.h>

#include "properties/diagnosis/models/first_hit/points.hpp"
#include "properties/diagnosis/models/first_hit/weights.hpp"
#include "properties/diagnosis/models/flat/weights.hpp"
#include "properties/diagnosis/models/flat/wrong_plane.hpp"
#include "properties/diagnosis/models/space/details_of_shapes.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

template <int decimals>
Hypothesis few_decimals_of_point() {
  return shows(
      kept(fmt::format("point-decimals-{}", decimals)), point_to_decimals<decimals>,
      kept(fmt::format("the point is rounded to multiples of 1e-{}: the code prints too few decimals, "
                       "or rounds",
                       decimals)),
      gross, Aspect::point);
}

}  // namespace

std::vector<Hypothesis> models_of_points() {
  return {
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
      gives_one_of("given-undivided", given_undivided,
                   "the hit is right, and beta, gamma or all three weights are given before they are divided "
                   "by the determinant",
                   gross, Aspect::coordinates),
      gives_one_of("weights-exchanged-along-axis", weights_exchanged_along_axis,
                   "the barycentric coordinates are exchanged where the triangle's normal is largest along "
                   "one axis: in one of the projections",
                   gross, Aspect::coordinates),
      shows("alpha-wrong", weight_is_wrong<0>, "alpha is wrong, and beta and gamma are right", gross,
            Aspect::coordinates),
      shows("beta-wrong", weight_is_wrong<1>, "beta is wrong, and alpha and gamma are right", gross,
            Aspect::coordinates),
      shows("gamma-wrong", weight_is_wrong<2>, "gamma is wrong, and alpha and beta are right", gross,
            Aspect::coordinates),
  };
}

}  // namespace rayproof::diagnosis
