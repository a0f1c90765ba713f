#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/triangle/whole.hpp"

namespace rayproof {

std::vector<Family> triangle_families() {
  using namespace triangle_family;
  return {
      laid_out<everyday>("random", "a triangle in a room, about half the rays hit",
                         {in_reach, {"hit", 0.38}, {"miss", 0.46}, {"behind", 0.05}}),
      laid_out<edges>("edges", "in whole numbers: the line passes exactly through an edge or a vertex",
                      {in_reach, {"hit", 0.83}, {"edge", 0.48}, {"vertex", 0.35}}),
      laid_out<near_edges>("near_edges",
                           "the line passes an ulp or so from an edge or a vertex, or any small step",
                           {in_reach, {"hit", 0.33}, {"miss", 0.51}}),
      laid_out<fans>("fans",
                     "one of a fan's triangles; the ray passes exactly through the hub or a shared edge",
                     {in_reach,
                      {"hit", 0.76},
                      {"miss", 0.08},
                      {"edge", 0.29},
                      {"vertex", 0.47},
                      {"in surface", 0.04},
                      {"degenerate", 0.02}}),
      laid_out<slivers>("slivers",
                        "the third vertex is 2^-3 lengths beside an edge, or down to 3/4 of the digits",
                        {in_reach, {"hit", 0.44}, {"miss", 0.4}}),
      laid_out<slender>("slender", "one edge is 2^-2 to 2^-12 times as long as another",
                        {in_reach, {"hit", 0.4}, {"miss", 0.2}}),
      from_the_horizon<near_edges, met>({{"hit", 0.2}, {"miss", 0.2}}),
      laid_out<far>("far", "the triangle is 1e2 to 1e6 sizes away, half the time aimed near an edge",
                    {in_reach, {"hit", 0.38}, {"miss", 0.45}}),
      laid_out<coplanar>("coplanar",
                         "in whole numbers: the ray runs in the triangle's plane, or parallel to it",
                         {in_reach, {"miss", 0.95}, {"in surface", 0.57}, {"parallel", 0.27}}),
      laid_out<near_coplanar>("near_coplanar", "the ray comes in at 2^-4 to an ulp off the triangle's plane",
                              {in_reach, {"hit", 0.43}, {"miss", 0.41}}),
      laid_out<decimals>("decimals", "in tenths: ray and triangle lie in one plane until they are rounded",
                         {in_reach, {"miss", 0.6}}),
      laid_out<degenerate>(
          "degenerate", "no area: vertices in a line, or two or three of them in one point; also almost so",
          {in_reach, {"hit", 0.04}, {"miss", 0.77}, {"vertex", 0.03}, {"degenerate", 0.64}}),
      cut_short<met>({in_reach, {"hit", 0.47}, {"miss", 0.34}, {"edge", 0.14}, {"behind", 0.34}}),
      placed<met>({{"in reach", 0.97}, {"hit", 0.25}, {"miss", 0.4}}),
      transformed<everyday, edges>(
          {in_reach, {"hit", 0.54}, {"miss", 0.3}, {"edge", 0.15}, {"vertex", 0.12}}),
      {"corners",
       "near a vertex, seen from anywhere, under an affine map of condition 3 to 300",
       ask<corners, move_and_look_again>,
       {in_reach, {"hit", 0.7}}},
      laid_out<off_origin>("off_origin", displaced_description, {in_reach, {"hit", 0.33}, {"miss", 0.4}}),
      beyond_the_digits<hard_to_round>("hard_to_round", hard::to_round_description, {in_reach, {"hit", 0.3}}),
      beyond_the_digits<hard_to_decide>("hard_to_decide", hard::to_decide_description,
                                        {in_reach, {"hit", 0.3}, {"miss", 0.3}, {"edge", 0.05}}),
      beyond_the_digits<beside_a_vertex>(
          "beside_a_vertex", "past a vertex by next to nothing, half the time on the line of an edge",
          {{"in reach", 0.3}, {"hit", 0.1}, {"miss", 0.3}}),
      beyond_the_digits<hard_coordinates>("hard_coordinates", hard::coordinate_description,
                                          {{"in reach", 0.5}, {"hit", 0.75}}),
      beyond_the_digits<hard_to_meet>("hard_to_meet", hard::to_meet_description,
                                      {in_reach, {"hit", 0.1}, {"miss", 0.3}}),
      of_the_smallest_size<slivers>({{"in reach", 0.2}, {"hit", 0.4}}),
      in_whole_numbers<whole_numbers>(
          "so short that little is rounded: edges, vertices, their lines, the plane",
          {in_reach, {"hit", 0.55}, {"miss", 0.29}, {"edge", 0.26}, {"vertex", 0.25}, {"in surface", 0.15}}),
      in_any_size<everyday>({{"hit", 0.38}, {"miss", 0.46}, {"behind", 0.05}}),
      special<Triangle<double>>({{"hit", 0.03}, {"miss", 0.8}}),
      bit_patterns<Triangle<double>>({{"hit", 0.04}, {"miss", 0.79}}),
  };
}

}  // namespace rayproof
