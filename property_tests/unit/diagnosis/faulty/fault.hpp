#pragma once
/// \file
/// Faults that people make in ray-intersection code, each planted alone in otherwise right textbook code.

namespace rayproof::faulty {

/// What is wrong with a program.
enum class Fault {
  nothing,
  // of any shape: the ray and its interval
  unit_direction,  ///< a = d·d is left out
  distance,        ///< the direction is normalised, and t is a distance
  ignores_t_max,
  ignores_t_min,
  t_min_is_zero,
  open_interval,
  near_root_only,  ///< a near root outside the interval makes a miss
  far_root,        ///< reports the far root in place of the near one
  one_admits_all,
  behind_counts,  ///< the sign of t is not looked at where all hits lie behind
  descending,
  epsilon,  ///< t must be greater than 1e-4
  limited,  ///< t must be less than 1e5
  segment,
  computes_in_float,
  // transforms
  ignores_transform,
  inverse_transform,
  direction_translated,
  origin_not_translated,
  object_distance,  ///< the object-space direction is normalised, and t is a distance there
  normal_by_matrix,
  normal_in_object,
  // the first hit
  normal_flipped,
  normal_faces_ray,
  normal_not_unit,
  point_in_object,
  point_without_origin,
  barycentric_order,
  barycentric_with_t,
  // sphere
  radius_not_squared,
  radius_is_diameter,
  centre_ignored,
  centre_negated,
  denominator_2ac,
  denominator_a,
  from_inside_missed,
  tangent_missed,
  no_radius_missed,
  // triangle
  no_sum_test,
  no_beta_test,
  no_test,
  culls_back,
  absolute_epsilon,
  edges_open,
  one_edge_open,
  lambda_sign,
  drops_z,
  no_area_hit,
  // plane
  constant_sign,
  constant_ignored,
  unit_normal,
  one_sided,
  no_coefficients,
  in_plane_hit,
  parallel_hit,  ///< at t = 0
  skewed_missed,
  contacts_exchanged,
  point_at_foot,
  // polygon and point in polygon
  closed_sides,
  open_sides,
  winding,
  last_side_missing,
  last_side_missing_above,  ///< and a vertex on the point's level counts as above it
  convex_only,
  first_triangle,
  // box and parallelepiped
  slab_z_missing,
  zero_times_infinity,
  no_exchange,
  starts_at_t_min,
  as_box,
  edge_missing,
  // cylinder
  no_height,
  caps_always,
  caps_never,
  circle,
  height_centred,
  caps_narrower,
  // quadratic
  no_linear,
  division_by_2,  ///< the division by a is missing
  abs_discriminant,
  double_twice,
  double_missed,
  wrong_order,  ///< the roots are in descending order where a < 0
  cancelling
};

}  // namespace rayproof::faulty
