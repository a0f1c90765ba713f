#include "generators/layout.hpp"
#include "generators/narrow.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/polygon/lifted.hpp"

namespace rayproof {

namespace {

template <const outline_layout::Layout& layout>
Family family_in_space(std::vector<MinimumShare> shares) {
  return laid_out<polygon_family::in_space<layout>>(layout.name, layout.description, std::move(shares));
}

}  // namespace

std::vector<Family> polygon_families() {
  using namespace polygon_family;
  namespace layout = outline_layout;
  return {
      in_whole_numbers<whole_numbers>(
          layout::whole.description,
          {in_reach, {"hit", 0.38}, {"miss", 0.4}, {"edge", 0.16}, {"vertex", 0.16}}),
      laid_out<everyday>(layout::everyday.name, layout::everyday.description,
                         {in_reach, {"hit", 0.39}, {"miss", 0.45}, {"behind", 0.06}}),
      family_in_space<layout::boundary>({in_reach, {"hit", 0.83}, {"edge", 0.51}, {"vertex", 0.32}}),
      family_in_space<layout::near_boundary>({in_reach, {"hit", 0.38}, {"miss", 0.45}}),
      family_in_space<layout::self_crossing>({in_reach, {"hit", 0.3}, {"miss", 0.54}}),
      family_in_space<layout::repeated>(
          {in_reach, {"hit", 0.16}, {"miss", 0.68}, {"edge", 0.04}, {"vertex", 0.012}, {"degenerate", 0.03}}),
      family_in_space<layout::no_area>({in_reach, {"miss", 0.95}, {"degenerate", 0.95}}),
      family_in_space<layout::narrow>({in_reach, {"hit", 0.25}, {"miss", 0.3}}),
      laid_out<coplanar>("coplanar",
                         "in whole numbers: the ray runs in the polygon's plane, or parallel to it",
                         {in_reach, {"miss", 0.95}, {"in surface", 0.62}, {"parallel", 0.21}}),
      laid_out<near_coplanar>("near_coplanar", "the ray comes in at 2^-4 to an ulp off the polygon's plane",
                              {in_reach, {"hit", 0.3}, {"miss", 0.3}}),
      from_the_horizon<in_space<layout::near_boundary>, met>({{"hit", 0.2}, {"miss", 0.2}}),
      laid_out<far>("far", "the ray comes from 1e2 to 1e6 away, half the time near the boundary",
                    {in_reach, {"hit", 0.42}, {"miss", 0.42}}),
      laid_out<off_origin>("off_origin", displaced_description, {in_reach, {"hit", 0.3}, {"miss", 0.4}}),
      laid_out<not_flat>("not_flat", "in whole numbers: the vertices lie in no plane",
                         {in_reach, {"hit", 0.3}, {"miss", 0.3}}),
      beyond_the_digits<hard_to_round>("hard_to_round", hard::to_round_description,
                                       {in_reach, {"hit", 0.15}}),
      beyond_the_digits<hard_to_decide>("hard_to_decide", hard::to_decide_description,
                                        {in_reach, {"hit", 0.3}, {"miss", 0.3}}),
      beyond_the_digits<hard_to_meet>("hard_to_meet", hard::to_meet_description,
                                      {in_reach, {"hit", 0.1}, {"miss", 0.3}}),
      of_the_smallest_size<in_space<layout::narrow>>({{"hit", 0.25}, {"miss", 0.3}}),
      cut_short<met>(
          {in_reach, {"hit", 0.37}, {"miss", 0.46}, {"edge", 0.18}, {"vertex", 0.1}, {"behind", 0.2}}),
      placed<met>({{"in reach", 0.97}, {"hit", 0.25}, {"miss", 0.4}}),
      transformed<everyday, in_space<layout::boundary>>(
          {in_reach, {"hit", 0.54}, {"miss", 0.3}, {"edge", 0.18}, {"vertex", 0.1}}),
      in_small<everyday>({in_reach, {"hit", 0.39}, {"miss", 0.45}, {"behind", 0.06}}),
      in_any_size<everyday>({{"hit", 0.39}, {"miss", 0.45}, {"behind", 0.06}}),
      special<Polygon<double>>({{"hit", 0.04}, {"miss", 0.79}}),
      bit_patterns<Polygon<double>>({{"hit", 0.05}, {"miss", 0.78}}),
  };
}

}  // namespace rayproof
