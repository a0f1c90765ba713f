#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/plane/layouts.hpp"

namespace rayproof {

std::vector<Family> plane_families() {
  using namespace plane_family;
  return {
      laid_out<everyday>("random", "a plane in a room, in any of its forms; most rays hit",
                         {in_reach, {"hit", 0.61}, {"miss", 0.23}, {"behind", 0.23}}),
      laid_out<near_parallel>("near_parallel", "the ray comes in at 2^-4 to an ulp off the plane",
                              {in_reach, {"hit", 0.42}, {"miss", 0.42}}),
      laid_out<in_plane>("in_plane", "in whole numbers: the ray runs exactly in the plane, or parallel to it",
                         {in_reach, {"miss", 0.95}, {"in surface", 0.61}, {"parallel", 0.23}}),
      laid_out<surface>("surface", "the origin lies in the plane or an ulp off, as secondary rays' do",
                        {in_reach, {"hit", 0.56}, {"miss", 0.27}}),
      laid_out<far>("far", "the origin, or the point that gives the plane, is 1e2 to 1e6 away",
                    {in_reach, {"hit", 0.95}}),
      laid_out<tiny_normal>("tiny_normal", "the numbers that give the plane's slope are tiny",
                            {in_reach, {"hit", 0.95}}),
      cut_short<met>({in_reach, {"hit", 0.49}, {"miss", 0.35}, {"in surface", 0.03}, {"behind", 0.3}}),
      transformed<everyday, in_plane>(
          {in_reach, {"hit", 0.41}, {"miss", 0.43}, {"in surface", 0.21}, {"parallel", 0.06}}),
      in_any_size<everyday>({{"hit", 0.61}, {"miss", 0.23}, {"behind", 0.23}}),
      special<ImplicitPlane, PointNormalPlane, ParametricPlane>({{"hit", 0.35}, {"miss", 0.49}}),
      bit_patterns<ImplicitPlane, PointNormalPlane, ParametricPlane>({{"hit", 0.38}, {"miss", 0.46}}),
  };
}

}  // namespace rayproof
