/// \file
/// Faults with cylinders.

#include "properties/diagnosis/models/cylinders/cap_outlines.hpp"
#include "properties/diagnosis/models/cylinders/caps.hpp"
#include "properties/diagnosis/models/cylinders/ends.hpp"
#include "properties/diagnosis/models/cylinders/readings.hpp"
#include "properties/diagnosis/models/cylinders/side.hpp"
#include "properties/diagnosis/models/cylinders/side_equation.hpp"
#include "properties/diagnosis/models/solids/solid.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {

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
      gives("caps-of-exchanged-radii", caps_of_exchanged_radii,
            "the caps are ellipses with rx and ry exchanged"),
      gives("caps-of-larger-radius", caps_of_larger_radius,
            "the caps are circles of the larger radius, and must be ellipses as the side is"),
      gives("caps-of-smaller-radius", caps_of_smaller_radius,
            "the caps are circles of the smaller radius, and must be ellipses as the side is"),
      gives("caps-of-rooted-radius", caps_of_rooted_radius,
            "a cap is hit where x² + y² <= r, and must be where x² + y² <= r²"),
      gives("caps-by-origin", caps_by_origin,
            "a cap is hit where the ray's origin lies within its outline, and must be where the point on the "
            "cap does"),
      gives(
          "upper-cap-by-lower-point", upper_cap_by_lower_point,
          "the cap at z = height is hit where the ray's point at z = 0 lies within the outline, and must be "
          "where the point on the cap does"),
      gives(
          "lower-cap-by-upper-point", lower_cap_by_upper_point,
          "the cap at z = 0 is hit where the ray's point at z = height lies within the outline, and must be "
          "where the point on the cap does"),
      gives("caps-outside-outline", caps_outside_outline,
            "a cap is hit outside of its outline: (x/rx)² + (y/ry)² >= 1 is asked, and must be <= 1"),
      gives("caps-at-opposite-t", caps_at_opposite_t,
            "t of a cap's plane has the wrong sign: it is (height - z) / d.z, and -z / d.z of the lower one"),
      gives("caps-from-outside-alone", caps_from_outside_alone,
            "a cap is hit from outside alone: a ray that leaves through it does not hit it"),
      following(
          "stops-before",
          shown_by(passes_cap_near_rim,
                   gives("cap-rim-missed", cap_rim_missed,
                         "hits on a cap near its rim are left out: the cap is narrower than the side"))),
      gives("caps-as-diamonds", caps_as_diamonds,
            "a cap is hit where |x|/rx + |y|/ry <= 1, and must be where the squares add up to 1 at most"),
      following(
          "upper-cap-missing",
          gives("first-cap-alone", first_cap_alone,
                "a ray that goes through both caps hits the lower one alone: the upper one is not looked at "
                "then")),
      gives("side-before-caps", side_before_caps,
            "a hit on the side is reported even where one on a cap is nearer"),
      gives("endless-cylinder", read_as<endless_cylinder>,
            "the answer is right for a cylinder without end: the height is not tested"),
      gives("upper-end-not-tested", upper_end_not_tested,
            "the upper end of the cylinder is not tested: z <= height is missing"),
      gives("lower-end-not-tested", lower_end_not_tested,
            "the lower end of the cylinder is not tested: z >= 0 is missing"),
      gives_one_of("end-tested-one-way", end_tested_one_way,
                   "one end of the cylinder is tested for rays that go up alone, or down alone"),
      gives("near-height-decides", near_height_decides,
            "the height of the side's nearer hit decides for both: each must be compared with the ends"),
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
      gives("side-about-zero", side_about_zero,
            "the side runs from -height/2 to height/2, and must from 0 to height"),
      gives("side-by-height-in-world", side_by_height_in_world,
            "the height of a hit on the side is measured in the world, and must be in object space"),
      gives_one_of(
          "side-by-mixed-height", side_by_mixed_height,
          "the height of a hit on the side is computed by the direction in the world and the origin in "
          "object space, or the other way round: both must be in object space"),
      gives("side-without-ends", side_without_ends,
            "the side goes on beyond the caps: the height is not tested there, neither below nor above"),
      gives_one_of(
          "side-constant-wrong", side_constant_wrong,
          "the constant of the side's equation is (x/rx)² + (y/ry)² - 1: a radius, or its square, or "
          "nothing, is subtracted in place of 1"),
      gives_one_of(
          "side-with-z", side_with_z_of_direction,
          "the coefficient of t² of the side is (dx/rx)² + (dy/ry)²: the direction's z must not be in it"),
      gives("direction-not-divided-by-radii", direction_not_divided_by_radii,
            "the side is right for a direction that is not divided by the radii: origin and direction both "
            "must be"),
      gives_one_of(
          "side-as-distance", side_as_distance,
          "the side's t is not divided by the length of the direction, seen along the axis: that was "
          "made a unit vector"),
      gives_one_of(
          "upper-cap-elsewhere", upper_cap_elsewhere,
          "the plane of the upper cap lies at another height, its square, twice it, half of it or 0, "
          "for all rays or for those that run upward"),
      gives_one_of(
          "side-chord-undivided", side_chord_undivided,
          "the chord of the side, seen along the axis, is not divided by the direction's length there: "
          "of a unit direction that is the sine of its angle to the axis"),
      gives("no-height-missed", no_height_is_missed,
            "a cylinder of height 0 is missed: it is valid, and an ellipse where it is capped"),
      gives("caps-where-side-missed", caps_where_side_missed,
            "the caps are hit only where the side is not hit at all: a ray may pass through both"),
      gives("side-where-caps-missed", side_where_caps_missed,
            "the side is hit only where no cap is: a ray may pass through both"),
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
      gives("rx-rooted", read_as<rx_rooted>, "the answer is right for the root of rx: rx stands for rx²"),
      gives("ry-rooted", read_as<ry_rooted>, "the answer is right for the root of ry: ry stands for ry²"),
      gives("height-rooted", read_as<height_rooted>,
            "the answer is right for the root of the height: z² is compared with it"),
      gives("side-mirrored", side_mirrored,
            "the side goes on below z = 0 as far as above: |z| <= height is asked"),
      gives("missed-along-side", missed_along_side,
            "a ray along the axis that runs in the side is missed: it meets both rims, which are the solid's",
            boundary),
      gives(
          "missed-along-axis-inside", missed_along_axis_inside,
          "a ray along the axis that starts inside is missed: the cap ahead of it is one that it leaves by"),
      gives("missed-along-axis", missed_along_axis,
            "every ray along the axis is missed, also where it hits a cap"),
      gives("missed-across-axis", missed_across_axis,
            "every ray at a right angle to the axis is missed: something is divided by d.z"),
      gives("radii-doubled", read_as<radii_doubled>, "the answer is right for twice the radii"),
      gives("radii-halved", read_as<radii_halved>,
            "the answer is right for half the radii: they are taken for diameters"),
      gives("radii-mean", read_as<radii_mean>,
            "the answer is right for a circle of the mean of rx and ry: the ellipse is taken for a circle"),
      gives("height-doubled", read_as<height_doubled>, "the answer is right for twice the height"),
      gives("height-halved", read_as<height_halved>, "the answer is right for half the height"),
      gives("radii-one", read_as<radii_one>, "the answer is right for radii of 1: they are ignored"),
      gives_one_of("radius-as-height", radius_as_height,
                   "the radius rx is taken for the height, of the whole cylinder or of its side alone"),
      gives("height-one", read_as<height_one>, "the answer is right for a height of 1: it is ignored"),
      gives("axis-is-x", read_as<cylinder_along<0>>, "the answer is right for a cylinder along x"),
      gives("axis-is-y", read_as<cylinder_along<1>>, "the answer is right for a cylinder along y"),
      gives("axis-turned-to-x", read_as<cylinder_turned_to<0>>,
            "the answer is right for a cylinder along x, its radii along y and z"),
      gives("axis-turned-to-y", read_as<cylinder_turned_to<1>>,
            "the answer is right for a cylinder along y, its radii along z and x"),
      gives("middle-at-zero", read_as<middle_at_zero>,
            "the answer is right for a cylinder from -height/2 to height/2"),
      gives("top-at-zero", read_as<top_at_zero>, "the answer is right for a cylinder from -height to 0"),
  };
}

}  // namespace rayproof::diagnosis
