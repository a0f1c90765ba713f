/// \file
/// Faults in the interval and in the list of hits.

#include "properties/diagnosis/models/hits/hits.hpp"
#include "properties/diagnosis/models/curved/near_sphere.hpp"
#include "properties/diagnosis/models/flat/flat.hpp"
#include "properties/diagnosis/models/hits/contacts.hpp"
#include "properties/diagnosis/models/hits/interval.hpp"
#include "properties/diagnosis/models/hits/line.hpp"
#include "properties/diagnosis/models/hits/starts.hpp"
#include "properties/diagnosis/models/hits/stretches.hpp"
#include "properties/diagnosis/models/hits/values.hpp"
#include "properties/diagnosis/models/hits/wrong_interval.hpp"
#include "properties/diagnosis/models/outlines/outline.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

/// That t = 0 is left out alone would be less.
Hypothesis positive_alone() {
  return shown_by(
      has_first_hit_behind_origin,
      of(OfSizes::small,
         gives("positive-t-alone", drops_not_positive,
               "hits with t <= 0 are left out though the interval admits them: t > 0 is asked, and "
               "must be t >= t_min")));
}

/// That the far hit alone is given from inside is right, or another fault.
Hypothesis far_hit_from_outside() {
  return shown_by(
      starts_outside,
      gives_one_of("far-hit-from-near", far_hit_from_near,
                   "from outside, but near a sphere, the far hit alone is given: the origin is taken to lie "
                   "inside, by a tolerance relative to the radius"));
}

/// That tangents are missed would be less.
Hypothesis near_rim_missed() {
  return shown_by(
      passes_below_surface,
      gives_one_of(
          "passing-near-rim-missed", passing_near_rim_missed,
          "a sphere is missed near its rim: the distance of the line from its centre is compared with "
          "the radius less a share of the origin's distance, a relative epsilon"));
}

/// Of rays without end it foresees misses alone.
Hypothesis compared_wrong_way_round() {
  return shown_by(has_hit_beyond_both,
                  gives("beyond-both-ends", beyond_both_ends,
                        "the answer is right for t > t_max: t is compared with t_max the wrong way round"));
}

/// Two hits taken for one by an absolute tolerance in t.
template <int power>
Hypothesis merged_hits() {
  return diagnosis::of_equation(
      kept(fmt::format("two roots nearer than about 1e{} are given as a double one", power)),
      below_power("hits-merged", power, near_hits_merged<power>,
                  "two hits nearer than about 1e{} in t are given as one: they are taken for the same"));
}

template <int power>
Hypothesis moved_hits() {
  return of(
      OfSizes::small,
      gives_one_of(kept(fmt::format("t-moved-1e{}", power)), offset_by<power>,
                   kept(fmt::format("every t is off by 1e{}, always to the same side: an offset against "
                                    "hits of the surface just left, added to t",
                                    power))));
}

/// The limit stands in the words. Without a hit so near the origin t_min would be ignored.
template <int power>
Hypothesis begins_behind_origin() {
  return shown_by(
      has_hit_behind<power>,
      gives(kept(fmt::format("begins-behind-1e{}", power)), begins_behind<power>,
            kept(fmt::format("hits behind the ray's beginning are reported down to t = -{}: that is "
                             "compared with t in the place of t_min",
                             std::pow(10.0, power)))));
}

}  // namespace

std::vector<Hypothesis> models_of_all_alike() {
  return {
      strictly(shows("all-at-minus-one", is_at_minus_one,
                     "every ray is said to hit at t = -1: the number that stands for a miss is given as a "
                     "hit")),
      shows("misses-at-minus-one", misses_at_minus_one,
            "where nothing is hit t = -1 is given as a hit: it is the number that stands for a miss"),
  };
}

std::vector<Hypothesis> models_of_hits() {
  return {
      misses_zero("open-where-entering", open_where_entering,
                  "a ray that begins on the surface and enters is given its exit: t > t_min is asked of the "
                  "entry, and must be t >= t_min"),
      misses_zero(
          "open-where-leaving", open_where_leaving,
          "a ray that begins on the surface and leaves it is missed: t > t_min is asked of the exit, and "
          "must be t >= t_min"),
      misses_zero("open-at-t-min", open_at_t_min,
                  "a hit exactly at t_min is left out: the interval is taken for open there"),
      misses_zero("open-at-t-max", open_at_t_max,
                  "a hit exactly at t_max is left out: the interval is taken for open there"),
      misses_zero("open-interval", open_at_both_ends,
                  "hits exactly at t_min and t_max are left out: the interval is taken for open"),
      misses_zero("open-at-zero", open_at_zero,
                  "a hit exactly at the ray's origin is left out: t > 0 is asked, and must be t >= 0"),
      positive_alone(),
      gives("zero-as-no-end", zero_as_no_end,
            "the answer is right without t_max where t_max = 0: 0 is taken for no end"),
      gives("far-hit-beyond", far_hit_beyond,
            "a ray that starts inside and ends there is said to hit beyond its end: the far hit is not "
            "compared with t_max"),
      gives("far-hit-not-compared", far_hit_not_compared,
            "t_max is compared with the near hit alone: a far one beyond it is reported, too"),
      gives("ignores-t-max", read_as<without_t_max>,
            "the answer is right for a ray without end: t_max is ignored"),
      gives("behind-origin-missed", behind_origin_missed,
            "what lies wholly behind the ray's origin is missed, though t_min is less than 0"),
      gives("t-min-cut-to-zero", t_min_cut_to_zero,
            "the answer is right for t_min = 0 where t_min is negative: t >= 0 is asked beside it"),
      gives("t-min-is-zero", t_min_is_zero, "the answer is right for t_min = 0: t_min is ignored"),
      gives("ignores-t-min", read_as<without_t_min>,
            "the answer is right without t_min: hits behind the ray's beginning are reported"),
      gives("interval-is-zero-to-inf", read_as<from_origin_on>,
            "the answer is right for the interval [0, inf]: t_min and t_max are ignored"),
      gives("whole-line", read_as<without_interval>,
            "the answer is right for the whole line: the interval of t is ignored"),
      gives_to_all("segment", read_as<as_segment>,
                   "the answer is right for t in [0, 1]: the ray is taken for a segment"),
      shown_by(has_hit_before_t_min, gives("t-min-as-t-max", t_min_as_t_max,
                                           "the answer is right for the interval [0, t_min]: t_min is taken "
                                           "for t_max, too")),
      gives("interval-as-distances", read_as<interval_as_distances>,
            "the answer is right where t_min and t_max are lengths: they are compared with distances, not "
            "with t"),
      gives("t-max-as-distance", read_as<t_max_as_distance>,
            "the answer is right where t_max is a length: it is compared with a distance, not with t"),
      gives(
          "t-max-as-object-distance", read_as<t_max_as_object_distance>,
          "the answer is right where t_max is a length in object space: it is compared with a distance, not "
          "with t"),
      gives_one_of("t-squared-to-t-max", t_squared_to_t_max,
                   "t_max is compared with the square of t, or of a distance, and must be with t: a square "
                   "root is missing"),
      gives("t-from-t-min", t_from_t_min, "t + t_min is right: t is counted from the interval's beginning"),
      gives("interval-as-object-distances", read_as<interval_as_object_distances>,
            "the answer is right where t_min and t_max are lengths in object space: they are compared with "
            "distances along the transformed ray, whose direction was made a unit vector"),
      gives("first-hit-decides", first_hit_decides,
            "it misses where the line's nearest hit lies before t_min, although a farther one lies in the "
            "interval: only the smaller root is looked at"),
      gives(
          "nearer-to-zero-decides", nearer_to_zero_decides,
          "of two roots the one with the smaller |t| is looked at alone: from inside it misses where the hit "
          "behind the origin is the nearer one"),
      gives("middle-behind-missed", missed_with_middle_behind,
            "a shape is missed whose middle, or the mean of its vertices, lies behind the ray's origin, "
            "though a part of "
            "it lies before"),
      gives("misses-from-inside", misses_from_inside, "every ray that starts inside misses"),
      gives("behind-is-hit", behind_is_hit,
            "what lies wholly behind the ray's beginning is reported: the sign of t is not looked at"),
      gives("one-hit-admits-all", one_hit_admits_all,
            "where one hit lies in the interval, the line's others are reported too: not each is compared "
            "with the interval"),
      gives("near-hit-behind", near_hit_behind,
            "a ray that starts inside is said to hit behind its beginning: the near hit is not compared with "
            "t_min"),
      far_hit_from_outside(),
      near_rim_missed(),
      gives("inside-decides", inside_decides,
            "from inside the farther of the two hits is given, from outside the nearer one: where the origin "
            "lies decides, and t is not compared with t_min"),
      gives("absolute-t-min", absolute_t_min, "the answer is right for |t_min|: its sign is lost"),
      gives("t-max-as-length", read_as<t_max_as_length>,
            "the answer is right for t_max - t_min in the place of t_max: the length of the interval is "
            "compared "
            "with t"),
      gives("farther-of-both", farther_of_both,
            "both of the line's hits must lie in the interval, and the farther one is reported"),
      compared_wrong_way_round(),
      gives("smaller-without-sign", smaller_without_sign,
            "of two roots the one of the smaller |t| is reported alone, and without its sign"),
      begins_behind_origin<0>(),
      begins_behind_origin<-1>(),
      begins_behind_origin<-2>(),
      begins_behind_origin<-3>(),
      begins_behind_origin<-4>(),
      begins_behind_origin<-5>(),
      gives("all-hits-or-none", all_hits_or_none,
            "it misses where one of the line's hits lies outside the interval, although another lies inside"),
      gives_one_of(
          "starts-at-zero", cut_off_at_zero,
          "the stretch inside is cut off at t = 0, or at the smallest positive number, as "
          "numeric_limits::min() is: a ray that starts inside is said to hit there, where there is no "
          "surface, and what lies behind is missed"),
      gives("starts-at-t-min", clipped_at_t_min,
            "a ray that starts inside is said to hit at t_min, where there is no surface"),
      gives(
          "behind-at-t-min", behind_at_t_min,
          "what lies behind the ray's beginning is reported as a hit at t_min: t is clamped to the interval"),
      gives("beyond-at-t-max", beyond_at_t_max,
            "what lies beyond the ray's end is reported as a hit at t_max: t is clamped to the interval"),
      gives("clipped-to-interval", clipped_to_interval,
            "where the interval ends inside the solid, its end is reported as a hit"),
      gives("exit-at-t-max", exit_at_t_max,
            "where the ray ends inside the solid t_max is reported as the hit where it leaves"),
      gives("zero-from-inside", zero_from_inside,
            "a ray whose origin is inside is said to hit at t = 0 alone, where there is no surface"),
      gives("solid-from-origin", solid_from_origin,
            "a ray whose origin is inside is said to hit at t = 0, where there is no surface, and what lies "
            "behind the origin is missed"),
      gives(
          "last-hit-alone", last_hit_alone,
          "of the line's hits the farthest one alone is looked at, in place of the nearest in the interval"),
      gives("farthest-hit", farthest_alone, "the farthest hit is reported in place of the nearest"),
      gives(
          "smallest-hit", smallest_alone,
          "of the hits in the interval the one of the smallest |t| is reported: t must be compared with its "
          "sign, since the interval may begin before 0"),
      shows("not-nearest", not_nearest,
            "a farther hit is reported in place of the nearest: that is kept which is found first, or last, "
            "and must be the one of the smallest t"),
      moved_hits<-6>(),
      moved_hits<-5>(),
      moved_hits<-4>(),
      moved_hits<-3>(),
      moved_hits<-2>(),
      merged_hits<-8>(),
      merged_hits<-7>(),
      merged_hits<-6>(),
      merged_hits<-5>(),
      merged_hits<-4>(),
      merged_hits<-3>(),
      merged_hits<-2>(),
      merged_hits<-1>(),
      gives("second-hit-missing", first_alone, "of two answers only the first is given"),
      gives("nearest-twice", nearest_twice, "of two answers the first is given twice"),
      gives("farthest-twice", farthest_twice, "of two answers the second is given twice"),
      gives("descending", descending, "the answers stand in descending order"),
      gives("plus-root-first", plus_root_first,
            "(-b + √D)/2a is given before (-b - √D)/2a: for a > 0 that is the descending order"),
      gives("minus-root-first", minus_root_first,
            "(-b - √D)/2a is given before (-b + √D)/2a: for a < 0 that is the descending order"),
      shows("not-sorted", not_sorted<RayQuestion>,
            "the hits are right, and do not always stand in ascending order: they are not sorted"),
      gives("root-alone", root_alone, "of two roots only one is given"),
      gives("double-hit-twice", double_hit_twice, "a double root is reported twice", boundary),
      gives("entry-and-exit-at-one-t", entry_and_exit_at_one_t,
            "where entry and exit are at one t, since the ray only touches or the solid is flat, that hit is "
            "listed "
            "twice"),
      gives("single-hit-twice", single_hit_twice,
            "where one hit alone is in the interval it is reported twice"),
      misses_zero("tangent-missed", misses_at<Contact::tangent>, "a ray that only touches is missed"),
      misses_zero(
          "tangent-missed-along-axes", misses_tangents_along_axes,
          "a ray that only touches is missed where it runs along an axis; elsewhere rounding decides"),
      misses_zero("edge-missed", misses_at<Contact::edge>,
                  "every hit on an edge is missed: the shape is taken without its edges"),
      misses_zero("vertex-missed", misses_at<Contact::vertex>, "every hit on a vertex is missed"),
      misses_zero("rim-missed", misses_at<Contact::rim>, "every hit on a rim is missed"),
      gives("vertex-not-on-boundary", lost_at<BoundaryPlace::vertex>,
            "a point at a vertex is not said to be on the boundary", boundary),
      gives("level-side-not-on-boundary", lost_at<BoundaryPlace::level_side>,
            "a point on a level side is not said to be on the boundary", boundary),
      gives("upright-side-not-on-boundary", lost_at<BoundaryPlace::upright_side>,
            "a point on an upright side is not said to be on the boundary", boundary),
      gives("closing-side-not-on-boundary", lost_at<BoundaryPlace::closing_side>,
            "a point on the side from the last vertex to the first is not said to be on the boundary: that "
            "side is not looked at there",
            boundary),
      gives("side-not-on-boundary", lost_between_vertices,
            "a point on a side, and not at a vertex, is not said to be on the boundary", boundary),
      gives("boundary-outside", boundary_is_outside, "the boundary is taken for outside: the set is open",
            boundary),
      gives("boundary-inside", boundary_is_inside, "the boundary is taken for inside", boundary),
  };
}

}  // namespace rayproof::diagnosis
