#pragma once
/// \file
/// Which fault is planted in which code, and what the diagnosis must call it.

#include <ostream>

#include "unit/diagnosis/faulty/faulty.hpp"

namespace rayproof::faulty {

/// A fault planted in the code of a topic, and the cause that must be named for the property it breaks.
struct Planted {
  const char* topic;
  Answer (*code)(const Case&);
  const char* property;
  const char* cause;
  Precision precision = Precision::float64;
};
/// What a failing test shows of it.
inline void PrintTo(const Planted& one, std::ostream* out) {
  *out << one.topic << ": " << one.cause << " by " << one.property << " in " << name_of(one.precision);
}

using enum Fault;

inline const Planted planted[] = {
    {"sphere", answer<unit_direction>, "residual", "unit-direction"},
    {"sphere", answer<distance>, "residual", "t-as-distance"},
    {"sphere", answer<ignores_t_max>, "verdict", "ignores-t-max"},
    {"sphere", answer<ignores_t_min>, "verdict", "ignores-t-min"},
    {"sphere", answer<t_min_is_zero>, "verdict", "t-min-is-zero"},
    {"sphere", answer<open_interval>, "boundary", "open-interval"},
    {"sphere", answer<near_root_only>, "verdict", "first-hit-decides"},
    {"sphere", answer<far_root>, "verdict", "farthest-hit"},
    {"sphere", answer<one_admits_all>, "verdict", "one-hit-admits-all"},
    {"sphere", answer<behind_counts>, "verdict", "behind-is-hit"},
    {"sphere", answer<descending>, "ascending", "descending"},
    {"sphere", answer<epsilon>, "verdict", "epsilon-1e-4"},
    {"sphere", answer<limited>, "verdict", "limit-1e5"},
    {"sphere", answer<segment>, "verdict", "segment"},
    {"sphere", answer<computes_in_float>, "residual", "computes-in-float"},
    {"sphere", answer<ignores_transform>, "verdict", "ignores-transform"},
    {"sphere", answer<inverse_transform>, "verdict", "inverse-transform"},
    {"sphere", answer<direction_translated>, "verdict", "direction-translated"},
    {"sphere", answer<origin_not_translated>, "verdict", "ignores-translation"},
    {"sphere", answer<object_distance>, "residual", "t-as-object-distance"},
    {"sphere", answer<normal_by_matrix>, "normal", "normal-by-matrix"},
    {"sphere", answer<normal_in_object>, "normal", "normal-in-object"},
    {"sphere", answer<normal_flipped>, "normal", "normal-flipped"},
    {"sphere", answer<normal_faces_ray>, "normal", "normal-faces-ray"},
    {"cylinder", answer<normal_not_unit>, "normal", "normal-not-unit"},
    {"sphere", answer<point_in_object>, "point", "point-in-object"},
    {"sphere", answer<point_without_origin>, "point", "point-without-origin"},
    {"triangle", answer<barycentric_order>, "coordinates", "barycentric-cba"},
    {"triangle", answer<barycentric_with_t>, "coordinates", "barycentric-u-v-t"},
    {"sphere", answer<radius_not_squared>, "verdict", "radius-rooted"},
    {"sphere", answer<radius_is_diameter>, "verdict", "radius-halved"},
    {"sphere", answer<centre_ignored>, "verdict", "centre-ignored"},
    {"sphere", answer<centre_negated>, "verdict", "centre-negated"},
    {"sphere", answer<denominator_2ac>, "residual", "over-constant"},
    {"sphere", answer<denominator_a>, "residual", "doubled"},
    {"sphere", answer<from_inside_missed>, "verdict", "misses-from-inside"},
    {"sphere", answer<tangent_missed>, "boundary", "tangent-missed"},
    {"sphere", answer<no_radius_missed>, "boundary", "point-missed"},
    {"triangle", answer<no_sum_test>, "verdict", "parallelogram"},
    {"triangle", answer<no_beta_test>, "verdict", "edge-b-not-tested"},
    {"triangle", answer<no_test>, "verdict", "whole-plane"},
    {"triangle", answer<culls_back>, "verdict", "culls-back-faces"},
    {"triangle", answer<absolute_epsilon>, "verdict", "slope-small-1e-2"},
    {"triangle", answer<edges_open>, "boundary", "boundary-outside"},
    {"triangle", answer<one_edge_open>, "boundary", "edge-a-open"},
    {"triangle", answer<lambda_sign>, "verdict", "lambda2-second-sign"},
    {"triangle", answer<drops_z>, "verdict", "upright-z"},
    {"triangle", answer<no_area_hit>, "verdict", "no-area-hit"},
    {"plane", answer<constant_sign>, "residual", "constant-negated"},
    {"plane", answer<constant_ignored>, "residual", "constant-ignored"},
    {"plane", answer<unit_normal>, "residual", "constant-as-distance"},
    {"plane", answer<one_sided>, "verdict", "culls-back-faces"},
    {"plane", answer<no_coefficients>, "residual", "coefficients-missing"},
    {"plane", answer<absolute_epsilon>, "verdict", "slope-small-1e-6"},
    {"plane", answer<parallel_hit>, "verdict", "parallel-hit"},
    {"plane", answer<skewed_missed>, "verdict", "skewed-missed"},
    {"plane", answer<contacts_exchanged>, "contact", "contacts-exchanged"},
    {"plane", answer<point_at_foot>, "point", "point-at-foot"},
    {"polygon", answer<closed_sides>, "verdict", "level-vertex"},
    {"polygon", answer<winding>, "verdict", "winding-rule"},
    {"polygon", answer<last_side_missing>, "verdict", "last-side-missing"},
    {"polygon", answer<last_side_missing_above>, "verdict", "last-side-missing"},
    {"polygon", answer<convex_only>, "verdict", "taken-as-convex"},
    {"polygon", answer<first_triangle>, "verdict", "first-triangle"},
    {"polygon", answer<culls_back>, "verdict", "culls-back-faces"},
    {"point_in_polygon", answer<closed_sides>, "verdict", "level-vertex"},
    {"point_in_polygon", answer<open_sides>, "verdict", "level-vertex"},
    {"point_in_polygon", answer<winding>, "verdict", "winding-rule"},
    {"point_in_polygon", answer<last_side_missing>, "verdict", "last-side-missing"},
    {"point_in_polygon", answer<last_side_missing_above>, "verdict", "last-side-missing"},
    {"point_in_polygon", answer<convex_only>, "verdict", "taken-as-convex"},
    {"point_in_polygon", answer<first_triangle>, "verdict", "first-triangle"},
    {"box", answer<slab_z_missing>, "verdict", "endless-box-z"},
    {"box", answer<zero_times_infinity>, "verdict", "missed-in-face"},
    {"box", answer<no_exchange>, "verdict", "slabs-unsorted"},
    {"box", answer<starts_at_t_min>, "verdict", "starts-at-t-min"},
    {"box", answer<ignores_t_max>, "verdict", "ignores-t-max"},
    {"parallelepiped", answer<as_box>, "verdict", "parallelepiped-as-box"},
    {"parallelepiped", answer<edge_missing>, "verdict", "endless-edge-2"},
    {"parallelepiped", answer<distance>, "residual", "t-as-distance"},
    {"cylinder", answer<no_height>, "verdict", "side-without-ends"},
    {"cylinder", answer<caps_always>, "verdict", "caps-added"},
    {"cylinder", answer<caps_never>, "verdict", "caps-missing"},
    {"cylinder", answer<circle>, "verdict", "circle-rx"},
    {"cylinder", answer<caps_narrower>, "verdict", "cap-rim-missed"},
    {"cylinder", answer<height_centred>, "verdict", "middle-at-zero"},
    {"cylinder", answer<segment>, "verdict", "segment"},
    {"quadratic", answer<no_linear>, "verdict", "linear-not-handled"},
    {"quadratic", answer<division_by_2>, "residual", "times-a"},
    {"quadratic", answer<denominator_a>, "residual", "doubled"},
    {"quadratic", answer<abs_discriminant>, "verdict", "discriminant-sign-lost"},
    {"quadratic", answer<double_twice>, "boundary", "double-hit-twice"},
    {"quadratic", answer<double_missed>, "boundary", "double-root-missed"},
    {"quadratic", answer<descending>, "ascending", "descending"},
    {"quadratic", answer<wrong_order>, "ascending", "minus-root-first"},
    {"quadratic", answer<cancelling>, "residual", "small-b", Precision::float32},
    {"quadratic", answer<cancelling>, "residual", "small-b"},
};

}  // namespace rayproof::faulty
