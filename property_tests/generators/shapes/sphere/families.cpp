#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/sphere/sizes.hpp"

namespace rayproof {

std::vector<Family> sphere_families() {
  using namespace sphere_family;
  const MinimumShare all_in_reach{"in reach", 1};
  return {
      laid_out<far>("far", "the sphere is 1e2 to 1e6 radii away",
                    {all_in_reach, {"hit", 0.4}, {"miss", 0.1}}),
      laid_out<everyday>("random", "a sphere in a room, about half the rays hit",
                         {all_in_reach, {"hit", 0.3}, {"miss", 0.2}, {"behind", 0.05}}),
      laid_out<grazing>("grazing", "the line passes the centre at r(1 ± a few ulps … 1e-3), or touches",
                        {all_in_reach, {"hit", 0.3}, {"miss", 0.2}, {"tangent", 0.05}}),
      laid_out<surface>("surface", "the origin lies on the surface or a few ulps off, as secondary rays' do",
                        {all_in_reach, {"hit", 0.3}, {"from inside", 0.2}}),
      laid_out<inside>("inside", "the origin lies inside, the centre included",
                       {all_in_reach, {"hit", 0.99}, {"from inside", 0.99}}),
      laid_out<tiny>("tiny", "a tiny radius, seen from a hundred radii or less",
                     {all_in_reach, {"hit", 0.4}, {"miss", 0.1}}),
      laid_out<huge>("huge", "a huge radius: a planet, half the time from just above its ground",
                     {all_in_reach, {"hit", 0.4}, {"miss", 0.02}}),
      laid_out<cancelling>("cancelling", "b² >> 4ac: looking at the surface from just above or below it",
                           {all_in_reach, {"hit", 0.4}, {"from inside", 0.2}}),
      laid_out<interval>("interval", "t_min or t_max at a hit or a few ulps beside it",
                         {all_in_reach, {"hit", 0.4}, {"cut", 0.2}}),
      transformed<near_its_origin>({all_in_reach, {"hit", 0.3}, {"miss", 0.1}}),
      laid_out<exponents>("exponents", "scenes of one size, of any exponent the format has",
                          {{"hit", 0.1}, {"miss", 0.1}}),
      special<Sphere<double>>({{"hit", 0.02}, {"miss", 0.3}}),
      bit_patterns<Sphere<double>>({{"hit", 0.02}, {"miss", 0.5}}),
  };
}

}  // namespace rayproof
