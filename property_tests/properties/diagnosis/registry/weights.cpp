/// \file
/// Faults in how a subject finds whether a point lies in a triangle, in a polygon or in a face.

#include "properties/diagnosis/models/flat/weights.hpp"
#include "properties/diagnosis/models/flat/wrong_cross.hpp"
#include "properties/diagnosis/models/flat/wrong_dots.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/solids/faces.hpp"
#include "properties/diagnosis/models/solids/slabs.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

template <int vertex>
Hypothesis turned_edge(char name, std::string_view edge) {
  return gives(kept(fmt::format("edge-{}-turned", name)), edge_turned<vertex>,
               kept(fmt::format(
                   "what lies beyond the edge {} is hit, and what lies on this side is not: a sign, or the "
                   "order of the edge's ends, is wrong there",
                   edge)));
}

template <int axis>
Hypothesis cross_product(char coordinate) {
  return gives_one_of(kept(fmt::format("cross-product-{}", coordinate)), wrong_cross<axis>,
                      kept(fmt::format("the {} of the cross product is wrong: a sign, the order, or another "
                                       "coordinate in it",
                                       coordinate)));
}

/// Of what is compared with a figure's sides: "o + t·n".
Hypothesis tested_point(std::string_view name, Predict predict, std::string_view point) {
  return gives_one_of(
      name, predict,
      kept(fmt::format("t is right, and {} is compared with the sides: the point is o + t·d", point)));
}

constexpr std::string_view edge_negated_in_words =
    "the answer is right with one edge turned round: the sign of a coordinate along it is wrong";

/// That a face is missed is foreseen by culling, too: a wrong hit must be given once.
Hypothesis signless_determinant() {
  Hypothesis made = gives_one_of(
      "determinant-without-sign", determinant_without_sign,
      "u, v and t have the wrong sign where the determinant is negative: its magnitude is taken");
  made.shows_more = [](const Case& one, const Answer& exact) {
    return std::ranges::any_of(determinant_without_sign(one, exact), [&](const Answer& foreseen) {
      return finds_something(foreseen) && !finds_something(exact);
    });
  };
  return made;
}

}  // namespace

std::vector<Hypothesis> models_of_weights() {
  return {
      gives(
          "weights-undivided", with_weights<undivided_weights>,
          "t is right, and u and v are not divided by the determinant before they are compared with 0 and 1"),
      gives("beta-undivided", undivided<&TriangleHit::beta>,
            "t is right, and u is not divided by the determinant before it is compared with 0 and 1"),
      gives("gamma-undivided", undivided<&TriangleHit::gamma>,
            "t is right, and v is not divided by the determinant before it is compared with 0 and 1"),
      gives(
          "weights-without-signs", weights_without_signs,
          "|u| + |v| <= 1 is asked, and must be u >= 0, v >= 0 and u + v <= 1: the triangle's mirror images "
          "about the vertex a are hit, too"),
      gives("weights-times-area", with_weights<undivided_by_area>,
            "t is right, and the weights are not divided by n·n, the square of twice the area"),
      gives_to_all("factors-exchanged", with_weights<exchanged_factors>,
                   "v and t have the wrong sign: the factors of a cross product are exchanged"),
      gives_one_of(
          "another-product", another_product,
          "u, v or t is what another of them is, or 0: they are (o - a)·p, d·q and (c - a)·q, each over the "
          "determinant, and in one of them another vector stands"),
      signless_determinant(),
      gives_one_of("edge-by-opposite-vertex", edge_by_opposite_vertex,
                   "of one edge the point's way is taken from the vertex opposite to it: it is (q - p) × "
                   "(point - p) with one p"),
      gives_one_of(
          "way-from-other-vertex", way_from_other_vertex,
          "the ray's way is taken from another vertex than the edges: it is o - a where these are b - a "
          "and c - a"),
      gives_one_of(
          "wrong-dots", wrong_dots,
          "one dot product, or one sign, is wrong in the weights of b and c, which are (f·f w·e - e·f w·f) "
          "/ D and (e·e w·f - e·f w·e) / D with e = b - a, f = c - a, w = p - a"),
      turned_edge<0>('a', "bc"),
      turned_edge<1>('b', "ca"),
      turned_edge<2>('c', "ab"),
      cross_product<0>('x'),
      cross_product<1>('y'),
      cross_product<2>('z'),
      tested_point("tested-against-direction", tested_at<against_direction>, "o - t·d"),
      tested_point("tested-without-origin", tested_at<without_start>, "t·d"),
      tested_point("tested-by-unit-direction", tested_at<by_unit_direction>, "o + t·d/|d|"),
      tested_point("tested-along-normal", tested_at<along_normal>, "o + t·n"),
      gives("faces-undivided", by_faces<undivided_face>,
            "a face's u and v are not divided by their determinant before they are compared with 0 and 1"),
      gives("face-u-undivided", by_faces<undivided_u>,
            "of a face's u and v one is not divided by their determinant before it is compared with 0 and 1"),
      gives("faces-of-unit-edges", by_faces<unit_face>,
            "a face's u and v are lengths along its edges, and are compared with 1: the edges are taken for "
            "unit "
            "vectors"),
      gives("faces-by-unit-projections", by_faces<unit_projections>,
            "a face's u and v are dot products with its edges: these are taken for unit vectors at right "
            "angles"),
      gives("face-v-not-tested", by_faces<endless_along_f>,
            "of a face's u and v one is not compared with 0 and 1: the faces are endless stripes"),
      gives("face-u-not-tested", by_faces<endless_along_e>,
            "of a face's u and v one is not compared with 0 and 1: the faces are endless stripes"),
      gives("faces-open", by_faces<open_face>,
            "hits on the edges of a face are left out: u and v must be compared by <= with 0 and 1",
            boundary),
      gives_one_of("face-missing", face_missing, "one of the six faces is missing"),
      gives("faces-as-triangles", by_faces<triangular_face>,
            "of each face one half alone is hit: u + v <= 1 is asked, and must not be"),
      gives("coordinates-undivided", read_as<edges_over_volume>,
            "the coordinates in the edges' frame are not divided by the determinant before they are compared "
            "with 0 "
            "and 1"),
      gives("over-volume", line_scaled_by<volume, -1>,
            "t is right times the determinant: of origin and direction in the edges' frame one alone is "
            "divided by it"),
      gives("times-volume", line_scaled_by<volume>,
            "t is right divided by the determinant: of origin and direction in the edges' frame one alone is "
            "divided by it"),
      gives("unit-in-edges", line_scaled_by<length_in_edges>,
            "t is a length in the edges' frame: the direction is made a unit vector there, and must not be"),
      gives("edges-doubled", read_as<edges_doubled>,
            "the answer is right for edges of twice the length: coordinates are compared with 2, and must be "
            "with 1"),
      gives(
          "edges-halved", read_as<edges_halved>,
          "the answer is right for edges of half the length: coordinates are compared with 1/2, and must be "
          "with 1"),
      gives("corner-negated", read_as<corner_negated>,
            "the answer is right for the corner's opposite: a sign is wrong in o - corner"),
      gives("edge-0-negated", read_as<edge_negated<0>>, edge_negated_in_words),
      gives("edge-1-negated", read_as<edge_negated<1>>, edge_negated_in_words),
      gives("edge-2-negated", read_as<edge_negated<2>>, edge_negated_in_words),
      gives("edges-both-ways", read_as<edges_both_ways>,
            "the answer is right for coordinates from -1 to 1: the corner is taken for the centre, and edges "
            "for "
            "half edges"),
  };
}

}  // namespace rayproof::diagnosis
