/// \file
/// Faults with the question whether a point lies in a polygon.

#include <fmt/format.h>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/flat/weights.hpp"
#include "properties/diagnosis/models/outlines/half_open_sides.hpp"
#include "properties/diagnosis/models/outlines/left_out.hpp"
#include "properties/diagnosis/models/outlines/near_sides.hpp"
#include "properties/diagnosis/models/outlines/outline.hpp"
#include "properties/diagnosis/models/outlines/small_box.hpp"
#include "properties/diagnosis/models/outlines/wrong_crossing.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

template <int power>
Hypothesis loose_sides() {
  return gives(kept(fmt::format("sides-loose-1e{}", power)), near_sides_inside<power>,
               kept(fmt::format("what lies nearer to a side than about 1e{} of the polygon's size is said to "
                                "be inside: a tolerance",
                                power)));
}

template <int power>
Hypothesis closed_gaps() {
  return gives(kept(fmt::format("gaps-closed-1e{}", power)), gap_is_inside<power>,
               kept(fmt::format("a gap between two sides that is narrower than about 1e{} of the polygon's "
                                "size is said to be inside: the sides are taken for one, by a tolerance",
                                power)));
}

constexpr std::string_view angles_in_words =
    "the angles at which the sides are seen are added without their signs: a side that turns back must be "
    "subtracted";

template <int power>
Hypothesis loose_boundary() {
  return below_power("boundary-loose", power, near_sides_boundary<power>,
                     "what lies beside a side is said to be on the boundary where the cross product is below "
                     "about 1e{}: an absolute epsilon");
}

template <int power>
Hypothesis near_boundary() {
  return below_power("boundary-near", power, within_of_boundary<power>,
                     "what is nearer to a side than about 1e{} is said to be on the boundary: an absolute "
                     "epsilon");
}

template <EndOfSide end>
Hypothesis end_not_on_boundary(std::string_view name, std::string_view words) {
  return gives(kept(fmt::format("{}-end-not-on-boundary", name)), lost_at_end<end>,
               kept(fmt::format("a vertex at which both its sides have their {} is not said to be on the "
                                "boundary: a side is taken without that end, by < where <= belongs",
                                words)),
               boundary);
}

template <std::size_t count>
Hypothesis of_first_vertices(std::string_view number) {
  return gives(kept(fmt::format("first-{}-vertices", number)), first_vertices<count>,
               kept(fmt::format("only the first {} vertices are looked at", number)));
}

template <int from>
Hypothesis missing_side(std::string_view name, std::string_view words) {
  return of_share(
      90, gives_one_of(name, side_missing<from>,
                       kept(fmt::format("the side from the {} is forgotten, or counts twice", words))));
}

/// What is right inside and wrong outside may look at no side at all.
Hypothesis angles_rounded() {
  return shown_by([](const Case& /*one*/, const Answer& exact) { return finds_something(exact); },
                  gives("angles-without-sign-rounded", inside_by<inside::angles_rounded>, angles_in_words));
}

constexpr std::string_view level_vertex_in_words =
    "a vertex level with the point counts for both its sides, or for neither: it must count for one";

constexpr std::string_view last_side_in_words =
    "the side from the last vertex to the first is forgotten, or counts twice";

constexpr std::string_view wrong_crossing_in_words =
    "x is compared with a wrong crossing: a side crosses the point's level at "
    "xi + (y - yi)·(xj - xi) / (yj - yi), and here a term, a sign or an index of that is another one";

}  // namespace

std::vector<Hypothesis> models_of_outlines() {
  return {
      gives("level-vertex", inside_by<inside::closed_sides>, level_vertex_in_words),
      gives("level-vertex-in-order", inside_by<inside::closed_sides, Sweep::along_in_order>,
            level_vertex_in_words),
      gives("level-vertex-by-order", inside_by<inside::closed_at_first>,
            "a vertex level with the point counts for the side that begins there, or that ends there, "
            "whichever way "
            "it leads: it must count for the side above it, or for that below it"),
      gives("level-sides-count", inside_by<inside::level_sides>,
            "a side level with the point counts as crossed, too: it must count for nothing"),
      gives("level-vertex-upward", inside_by<inside::closed_sides, Sweep::upward>,
            "a vertex straight above or below the point counts for both its sides, or for neither: it must "
            "count "
            "for one"),
      gives("level-outside", inside_by<inside::not_level>,
            "a point level with a vertex is taken for outside"),
      gives_to_all("hit-exchanged", exchanged_in_projection,
                   "the hit's two coordinates in the projection are exchanged, and those of the vertices are "
                   "not"),
      gives("winding-rule", inside_by<inside::winding>,
            "the answer is right for the non-zero winding rule, and not for the even-odd one"),
      gives("endless-sides", inside_by<inside::endless_sides>,
            "a side counts as crossed beyond its second vertex, too: it is taken for an endless half line"),
      gives("both-ways", inside_by<inside::both_ways>,
            "crossings on both sides of the point are counted: x is not compared"),
      gives_to_all("last-side-missing", inside_by<inside::last_side>, last_side_in_words),
      gives_to_all("last-side-missing-against", inside_by<inside::last_side, Sweep::against>,
                   last_side_in_words),
      gives_to_all("last-side-missing-in-order", inside_by<inside::last_side, Sweep::along_in_order>,
                   last_side_in_words),
      gives_to_all("last-side-missing-against-in-order",
                   inside_by<inside::last_side, Sweep::against_in_order>, last_side_in_words),
      gives_to_all("last-side-missing-upward", inside_by<inside::last_side, Sweep::upward>,
                   last_side_in_words),
      gives_to_all("last-side-missing-downward", inside_by<inside::last_side, Sweep::downward>,
                   last_side_in_words),
      missing_side<0>("first-side-missing", "first vertex to the second"),
      missing_side<1>("second-side-missing", "second vertex to the third"),
      missing_side<-2>("last-but-one-side-missing", "last vertex but one to the last"),
      gives("first-triangle", inside_by<inside::first_triangle>,
            "only the first three vertices are looked at"),
      gives(
          "side-without-length", on_side_without_length,
          "where a vertex stands twice in a row every point is said to be on the boundary: the side between "
          "has no length, and all that is asked of it is 0"),
      gives("endless-boundary", endless_boundary,
            "a point on the line of a side, beyond its ends, is said to be on the boundary"),
      gives(
          "endless-upright-boundary", endless_upright_boundary,
          "a point on the line of an upright side, beyond its ends, is said to be on the boundary: y is not "
          "compared"),
      end_not_on_boundary<EndOfSide::right>("right", "greatest x"),
      end_not_on_boundary<EndOfSide::left>("left", "least x"),
      end_not_on_boundary<EndOfSide::upper>("upper", "greatest y"),
      end_not_on_boundary<EndOfSide::lower>("lower", "least y"),
      gives("lost-on-bounds", lost_on_bounds,
            "a point of the boundary on the border of the bounding box is said to be outside: the box is "
            "compared by <= and >= where < and > belong",
            boundary),
      gives("lost-at-greatest", lost_at_greatest,
            "a point of the boundary at the greatest x or y of the polygon is said to be outside: the "
            "bounding box "
            "is compared by < where <= belongs",
            boundary),
      gives("angles-without-sign", inside_by<inside::angles>, angles_in_words),
      gives("angles-without-sign-or-more", inside_by<inside::angles_or_more>, angles_in_words),
      angles_rounded(),
      gives(
          "bounds-of-three", inside_by<inside::bounds_of_three>,
          "what lies outside the bounding box of the first three vertices is said to be outside: that box is "
          "too small"),
      gives_one_of("bounds-but-one", outside_small_box,
                   "what lies outside the bounding box of all vertices but the first, or the last, or of two "
                   "of them, is "
                   "said to be outside: that box is too small"),
      of_first_vertices<4>("four"),
      of_first_vertices<5>("five"),
      of_first_vertices<6>("six"),
      of_first_vertices<7>("seven"),
      of_first_vertices<8>("eight"),
      of_first_vertices<10>("ten"),
      of_first_vertices<12>("twelve"),
      of_first_vertices<16>("sixteen"),
      gives("upright-sides", inside_by<inside::upright_sides>,
            "an upright side counts as crossed on whichever side of the point it lies: x is not compared "
            "there"),
      gives("repeated-vertices", inside_by<inside::unrepeated>,
            "a vertex that has been there before is left out, and a side goes past it"),
      gives("inequality-unturned", inside_by<inside::unturned>,
            "an inequality is multiplied by a side's height, which may be negative, and not turned round"),
      gives(
          "sides-cut-off", inside_by<inside::cut_off_turns>,
          "the product that says on which side of a side the point lies is cut off to a whole number: beside "
          "a side it is 0"),
      gives_to_all("compares-first-vertex", inside_by<inside::first_end>,
                   "x is compared with a vertex of the side, and must be with the crossing"),
      gives_to_all("compares-second-vertex", inside_by<inside::second_end>,
                   "x is compared with a vertex of the side, and must be with the crossing"),
      gives_to_all("compares-farther-vertex", inside_by<inside::farther_end>,
                   "x is compared with the larger x of a side's two vertices, and must be with the crossing"),
      gives_one_of("crossing-wrong", wrong_crossing<Sweep::along>, wrong_crossing_in_words),
      gives_one_of("crossing-wrong-against", wrong_crossing<Sweep::against>, wrong_crossing_in_words),
      gives_one_of("crossing-wrong-in-order", wrong_crossing<Sweep::along_in_order>, wrong_crossing_in_words),
      gives_one_of("crossing-wrong-upward", wrong_crossing<Sweep::upward>, wrong_crossing_in_words),
      gives_to_all("any-crossing", inside_by<inside::any_crossing>,
                   "one crossed side is enough: crossings must be counted, even or odd"),
      gives_to_all("one-way-sides", inside_by<inside::upward>,
                   "a side counts as crossed in one direction alone, upward or downward"),
      gives("never-inside", never_inside,
            "no point is ever said to be inside: where x is not compared, the sides crossed on both sides of "
            "it "
            "are even; and angles that are not brought between -π and π add up to 0"),
      gives("taken-as-convex", inside_by<inside::one_side>,
            "inside is where all sides turn one way: the polygon is taken for convex"),
      gives("fan-of-triangles", fan_of_triangles,
            "the polygon is cut into a fan of triangles from its first vertex, each in its own plane: it is "
            "taken for convex, and for flat"),
      gives("fan", inside_by<inside::fan>,
            "inside is what lies in a triangle of the fan from the first vertex: the polygon is taken for "
            "convex"),
      gives("inside-out", inside_out, "inside is called outside, and outside inside"),
      loose_boundary<-9>(),
      loose_boundary<-8>(),
      loose_boundary<-7>(),
      loose_boundary<-6>(),
      loose_boundary<-5>(),
      loose_boundary<-4>(),
      loose_boundary<-3>(),
      loose_boundary<-2>(),
      near_boundary<-9>(),
      near_boundary<-8>(),
      near_boundary<-7>(),
      near_boundary<-6>(),
      near_boundary<-5>(),
      near_boundary<-4>(),
      near_boundary<-3>(),
      near_boundary<-2>(),
      near_boundary<-1>(),
      closed_gaps<-6>(),
      closed_gaps<-5>(),
      closed_gaps<-4>(),
      closed_gaps<-3>(),
      loose_sides<-5>(),
      loose_sides<-4>(),
      loose_sides<-3>(),
      loose_sides<-2>(),
      gives("bounding-box", inside_by<inside::bounds>, "the whole bounding box of the polygon is hit"),
  };
}

}  // namespace rayproof::diagnosis
