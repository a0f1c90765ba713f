#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/disk/layouts.hpp"
#include "generators/whole.hpp"

namespace rayproof {

std::vector<Family> disk_families() {
  using namespace disk_family;
  return {
      laid_out<everyday>("random", "a disk in a room, aimed at within and beside it",
                         {in_reach, {"hit", 0.4}, {"miss", 0.3}}),
      laid_out<rim>(
          "rim",
          "in whole numbers: aimed exactly at the rim, the centre or beside; some rays run in the plane",
          {in_reach, {"hit", 0.42}, {"miss", 0.3}, {"rim", 0.3}, {"in surface", 0.02}}),
      laid_out<near_rim>("near_rim", "aimed at the rim and 2^-4 of the radius to an ulp beside it",
                         {in_reach, {"hit", 0.3}, {"miss", 0.3}}),
      in_whole_numbers<rim>("so short that little is rounded: the rim, the centre, in the plane",
                            {in_reach, {"hit", 0.4}, {"rim", 0.25}, {"in surface", 0.01}}),
      cut_short<rim>({in_reach, {"hit", 0.3}, {"miss", 0.3}, {"rim", 0.15}}),
      transformed<everyday, rim>({in_reach, {"hit", 0.4}, {"miss", 0.3}, {"rim", 0.08}}),
      in_any_size<everyday>({{"hit", 0.4}, {"miss", 0.3}}),
      special<Disk<double>>({{"hit", 0.03}, {"miss", 0.6}}),
      bit_patterns<Disk<double>>({{"hit", 0.05}, {"miss", 0.6}}),
  };
}

}  // namespace rayproof
