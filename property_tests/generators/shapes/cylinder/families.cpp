#include "generators/hard_to_round.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/cylinder/hard.hpp"
#include "generators/shapes/cylinder/layouts.hpp"
#include "generators/shapes/cylinder/whole.hpp"

namespace rayproof {

std::vector<Family> cylinder_families() {
  using namespace cylinder_family;
  return {
      laid_out<everyday>("random", "a cylinder in a room, open or capped, about half the rays hit",
                         {in_reach, {"hit", 0.36}, {"miss", 0.48}, {"behind", 0.04}}),
      laid_out<far>("far", "the cylinder is 1e2 to 1e6 sizes away, half the time near its limb",
                    {in_reach, {"hit", 0.56}, {"miss", 0.28}}),
      laid_out<grazing>("grazing",
                        "the line passes the side at (1 ± a few ulps … 1e-3) of the radii, or touches",
                        {in_reach, {"hit", 0.54}, {"miss", 0.3}, {"tangent", 0.11}, {"rim", 0.11}}),
      laid_out<rims>(
          "rims",
          "the line passes through a rim: exactly, in whole numbers, or an ulp or any small step beside",
          {in_reach, {"hit", 0.68}, {"miss", 0.15}, {"rim", 0.36}, {"in surface", 0.02}}),
      laid_out<caps>("caps", "the line passes through an end disk, near its rim half the time",
                     {in_reach, {"hit", 0.61}, {"miss", 0.23}}),
      laid_out<axis_parallel>("axis_parallel",
                              "the ray runs along the axis: inside, outside, in the side, or almost along it",
                              {in_reach, {"hit", 0.23}, {"miss", 0.61}, {"rim", 0.16}, {"in surface", 0.16}}),
      laid_out<near_parallel>("near_parallel", "the ray comes in at 2^-4 to an ulp off the side",
                              {in_reach, {"hit", 0.9}}),
      laid_out<cap_planes>("cap_planes", "the ray runs exactly in the plane of an end",
                           {in_reach, {"hit", 0.81}, {"miss", 0.02}, {"rim", 0.82}}),
      laid_out<flat_ellipses>("flat_ellipses", "one radius is up to 1e4 times the other",
                              {in_reach, {"hit", 0.57}, {"miss", 0.27}}),
      laid_out<inside>("inside", "the origin lies inside, on the axis now and then",
                       {in_reach, {"hit", 0.63}, {"miss", 0.21}, {"cut", 0.54}, {"from inside", 0.54}}),
      laid_out<surface>(
          "surface", "the origin lies on the side or an end, or an ulp off, as secondary rays' do",
          {in_reach, {"hit", 0.66}, {"miss", 0.18}, {"rim", 0.1}, {"cut", 0.24}, {"from inside", 0.1}}),
      laid_out<no_height>("no_height", "a height of 0, or hardly any",
                          {in_reach, {"hit", 0.56}, {"miss", 0.28}, {"rim", 0.38}}),
      beyond_the_digits<hard_to_round, maybe_stretch>("hard_to_round", hard::to_round_description,
                                                      {{"in reach", 0.7}, {"hit", 0.5}}),
      beyond_the_digits<hard_to_decide, maybe_stretch>(
          "hard_to_decide",
          "the line passes a rim by a part that twice the digits hide, or exactly through it",
          {in_reach, {"hit", 0.3}}),
      cut_short<side>({in_reach,
                       {"hit", 0.58},
                       {"miss", 0.25},
                       {"tangent", 0.01},
                       {"rim", 0.14},
                       {"in surface", 0.02},
                       {"behind", 0.22},
                       {"cut", 0.28}}),
      placed<side>({{"in reach", 0.97}, {"hit", 0.25}, {"miss", 0.4}}),
      transformed<everyday, rims>({in_reach, {"hit", 0.48}, {"miss", 0.36}, {"rim", 0.12}}),
      in_whole_numbers<whole_numbers>(
          "so short that little is rounded: rims, tangents, ends and their planes", {in_reach,
                                                                                     {"hit", 0.5},
                                                                                     {"miss", 0.33},
                                                                                     {"rim", 0.38},
                                                                                     {"tangent", 0.02},
                                                                                     {"in surface", 0.04},
                                                                                     {"cut", 0.07}}),
      in_any_size<everyday>({{"hit", 0.36}, {"miss", 0.48}, {"behind", 0.04}}),
      special<Cylinder<double>>({{"hit", 0.06}, {"miss", 0.76}}),
      bit_patterns<Cylinder<double>>({{"hit", 0.05}, {"miss", 0.78}}),
  };
}

}  // namespace rayproof
