/// \file
/// The cures.

#include "properties/diagnosis/cures/cures.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {

std::vector<Hypothesis> cures_of_values() {
  return {
      {.name = "asked-alone",
       .kind = gross,
       .sentence =
           "right when it is asked this case alone: the answer depends on the cases asked before, or on "
           "chance",
       .change = unchanged,
       .perturbs = false,
       .asked = Asking::alone},
      {.name = "asked-again",
       .kind = gross,
       .sentence =
           "the answer is another one when the same case is asked again: it depends on chance, the time, or "
           "memory that was never set",
       .change = unchanged,
       .perturbs = false,
       .asked = Asking::again},
      exact_cure("minus-zero", without_minus_zero,
                 "right as soon as 0 stands for -0: the sign of zero is taken for a sign"),
      of(OfSizes::small,
         exact_cure(
             "larger-scene", larger_scene,
             "right as soon as the scene is larger: the code takes small lengths for 0, by an absolute "
             "epsilon or by rounding to whole numbers",
             gross,
             "right as soon as the roots are larger: the code takes a small coefficient, or a small "
             "discriminant, for 0, an absolute epsilon")),
      of(OfSizes::limit,
         of_point(
             "right as soon as the numbers are smaller: a fixed largest number, or products that overflow",
             exact_cure("smaller-scene", smaller_scene,
                        "right as soon as the scene is smaller: a fixed largest distance, an overflow, or a "
                        "direction so small beside the shape that it is taken for 0",
                        gross,
                        "right as soon as the roots are smaller: a fixed largest number, or an overflow"))),
      of(OfSizes::small,
         following(
             "unit-direction",
             exact_cure(
                 "longer-direction", longer_direction,
                 "right as soon as the direction is longer: the code takes small products with it for 0, an "
                 "absolute epsilon",
                 gross,
                 "right as soon as a, b and c are larger: the code takes a small coefficient, or a small "
                 "discriminant, for 0, an absolute epsilon"))),
      of(OfSizes::limit,
         exact_cure("shorter-direction", shorter_direction,
                    "right as soon as the direction is shorter: something overflows, or has a fixed limit",
                    gross,
                    "right as soon as a, b and c are smaller: something overflows, or has a fixed limit")),
      of(OfSizes::extremes,
         exact_cure("ordinary-sizes", ordinary_sizes,
                    "right as soon as lengths and direction are of ordinary size", FindingKind::range)),
      exact_cure("positive-a", positive_a,
                 "right as soon as a > 0: the order of the roots, or a sign, is wrong for a < 0"),
      exact_cure(
          "positive-direction", positive_direction,
          "right as soon as no component of the direction is negative: near and far slab are not exchanged"),
      exact_cure("other-first-vertex", other_first_vertex,
                 "right as soon as another vertex is the first: something is taken from the first vertices "
                 "alone, as a plane, a turn or a box is, or a side or a vertex is left out"),
      exact_cure("reversed-winding", reversed_winding,
                 "right as soon as the winding is reversed: only one orientation is handled"),
      exact_cure(
          "renamed-axes", renamed_axes,
          "right as soon as the axes are renamed: one coordinate is treated otherwise than the others, or "
          "always left out"),
      exact_cure(
          "tilted", tilted,
          "right as soon as the direction is tilted off the axes: 0·∞ or a division by a component that "
          "is 0"),
      exact_cure("without-tiny-component", without_tiny_component,
                 "right as soon as a component of the direction is 0 that is tiny beside the others: what "
                 "decides is a coordinate in which the ray hardly moves"),
      cure("turned", turned,
           "right as soon as the scene is turned off the axes: a direction, a side or a plane along an axis "
           "is not handled"),
      cure("unit-direction", unit_direction,
           "right as soon as the direction has length 1: the code takes it for a unit vector"),
      cure("unit-normal", unit_normal,
           "right as soon as the normal has length 1: the code takes it for a unit vector"),
      cure("leading-one", leading_one, "right as soon as a = 1: the code forgets a"),
      cure("in-object-space", in_object_space,
           "right with the same ray in object space, without the transform: the fault lies in the transform",
           gross, Keeps::verdict),
      vague(cure("plain-interval", plain_interval,
                 "right as soon as the interval is [0, inf]: the fault lies with t_min or t_max", gross,
                 Keeps::verdict)),
      cure("start-behind", start_behind,
           "right as soon as the ray starts before its line meets the shape: an origin inside, or hits "
           "behind it, are not handled",
           gross, Keeps::verdict),
      of(OfSizes::small, cure("wider", wider,
                              "right as soon as the triangle is as wide as it is long: a thin one is taken "
                              "for one without area")),
      of(OfSizes::small, cure("steeper", steeper,
                              "right as soon as the ray meets the plane at a steep angle: a grazing one is "
                              "taken for parallel")),
      following("divides-by-what-cancels",
                cure("small-b", small_b, "right as soon as b² is not much larger than 4ac: -b ± √D cancels",
                     rounding)),
      cure("start-near", start_near,
           "right as soon as the ray starts near the shape: from afar its equation cancels", rounding,
           Keeps::verdict),
      exact_cure("in-double", in_double, "right with the same numbers in double: float32 loses the digits",
                 rounding),
      of_digits_or(
          "right as soon as the shape is at the origin of coordinates: its place is ignored, or taken "
          "wrongly",
          cure("shape-at-zero", shape_at_zero,
               "right as soon as the shape is at the origin of coordinates: far from it digits cancel",
               rounding)),
      of_lost_hits(vague(
          cure("nearer-the-middle", nearer_the_middle,
               "right as soon as the ray passes nearer to the middle of the shape: near its corners or ends "
               "something is cut off"))),
      vague(cure("farther-off", farther_off,
                 "right as soon as the ray passes farther away: the shape is taken for larger than it is")),
  };
}

std::vector<Hypothesis> cures_of_boundaries() {
  return {
      avoids("off-level", off_level,
             "right as soon as no vertex is level with the point: a ray through a vertex counts wrongly"),
      avoids("off-interval-ends", off_interval_ends,
             "right as soon as no hit lies on an end of the interval"),
      of_digits_or(
          "right as soon as the ray or point lies a little aside: numbers that are 0, or equal, are not "
          "handled",
          of_equation(
              "right as soon as a coefficient changes a little: only double roots, or coefficients that "
              "are 0, are wrong",
              avoids(
                  "off-boundary", off_boundary,
                  "right as soon as the ray or point lies a little aside: only edges, vertices and tangents "
                  "are wrong"))),
      avoids("few-digits", few_digits,
             "right as soon as the numbers have few digits: what is wrong is rounding", rounding),
      of_digits_or(
          "right as soon as any number changes a little: numbers that are 0, or equal, are not handled",
          avoids("isolated", jiggled,
                 "right as soon as any number changes a little: an isolated case of rounding", rounding)),
  };
}

}  // namespace rayproof::diagnosis
