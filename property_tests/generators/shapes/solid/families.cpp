#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/solid/layouts.hpp"

namespace rayproof {

namespace {

/// The families of one kind of solid. Both have the same: what is hard is where two faces meet. `flat_shares`
/// is what the flat ones must produce, of which only a box may have no thickness at all.
template <class Kind>
std::vector<Family> solid_families(const std::vector<MinimumShare>& flat_shares) {
  using namespace solid_family;
  return {
      laid_out<everyday<Kind>>("random", "a solid in a room, about half the rays hit",
                               {in_reach, {"hit", 0.39}, {"miss", 0.43}, {"behind", 0.05}}),
      laid_out<axis_parallel<Kind>>(
          "axis_parallel",
          "one or two components of the direction are exactly 0 or -0, some in the plane of a face",
          {in_reach, {"hit", 0.4}, {"miss", 0.37}, {"sharp", 0.004}}),
      laid_out<edges<Kind>>("edges", "in whole numbers: the line passes exactly through an edge or a corner",
                            {in_reach, {"hit", 0.95}, {"tangent", 0.32}, {"sharp", 0.74}}),
      laid_out<near_edges<Kind>>("near_edges", "the line passes an ulp or so from an edge or a corner",
                                 {in_reach, {"hit", 0.57}, {"miss", 0.24}}),
      laid_out<in_faces<Kind>>("in_faces",
                               "in whole numbers: the ray runs in the plane of a face or along an edge",
                               {in_reach, {"hit", 0.42}, {"miss", 0.41}, {"tangent", 0.03}, {"sharp", 0.52}}),
      laid_out<surface<Kind>>(
          "surface", "the origin lies on a face, an edge or a corner, or an ulp off, as secondary rays' do",
          {in_reach, {"hit", 0.67}, {"tangent", 0.21}, {"sharp", 0.3}, {"cut", 0.24}, {"from inside", 0.03}}),
      laid_out<flat<Kind>>("flat", "the solid is nearly flat, or exactly where it may be", flat_shares),
      laid_out<inside<Kind>>("inside", "the origin lies inside",
                             {in_reach, {"hit", 0.95}, {"cut", 0.95}, {"from inside", 0.95}}),
      laid_out<far<Kind>>("far", "the solid is 1e2 to 1e6 sizes away, half the time aimed near an edge",
                          {in_reach, {"hit", 0.74}, {"miss", 0.1}}),
      cut_short<faces<Kind>>({in_reach,
                              {"hit", 0.65},
                              {"miss", 0.18},
                              {"tangent", 0.09},
                              {"sharp", 0.25},
                              {"behind", 0.18},
                              {"cut", 0.38}}),
      transformed<everyday<Kind>, edges<Kind>>(
          {in_reach, {"hit", 0.54}, {"miss", 0.29}, {"tangent", 0.11}, {"sharp", 0.25}}),
      in_any_size<everyday<Kind>>({{"hit", 0.39}, {"miss", 0.43}, {"behind", 0.05}}),
      special<typename Kind::Solid>({{"hit", 0.03}, {"miss", 0.77}}),
      bit_patterns<typename Kind::Solid>({{"hit", 0.03}, {"miss", 0.78}}),
  };
}

}  // namespace

std::vector<Family> box_families() {
  return solid_families<solid_family::Boxes>(
      {in_reach, {"hit", 0.4}, {"miss", 0.4}, {"sharp", 0.15}, {"tangent", 0.12}});
}
std::vector<Family> parallelepiped_families() {
  return solid_families<solid_family::Oblique>({in_reach, {"hit", 0.6}, {"miss", 0.15}});
}

}  // namespace rayproof
