/// \file
/// How wrong the answers to failing cases are, and how large their numbers.

#include <algorithm>
#include <cmath>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/changes.hpp"
#include "properties/diagnosis/examination/agreement.hpp"
#include "properties/diagnosis/examination/examination.hpp"

namespace rayproof::diagnosis {
namespace {

/// The length of the difference of two normals; 0 where one of them is not there.
double error_of_normal(const Answer& got, const Answer& exact) {
  const auto *ours = std::get_if<RayAnswer>(&got), *right = std::get_if<RayAnswer>(&exact);
  const bool are_both = ours != nullptr && right != nullptr && ours->normal && right->normal;
  return are_both ? glm::length(*ours->normal - *right->normal) : 0;
}

/// Whether of two roots the larger is right, and the smaller is wrong by a rounding of the larger one: that
/// is what -b ± √D does to it, which may lose all of its digits.
bool loses_the_smaller_root(const Answer& got, const Answer& exact, double unit) {
  if (!std::holds_alternative<QuadraticAnswer<double>>(exact)) return false;
  const std::vector<double> mine = numbers_in(got), right = numbers_in(exact);
  if (mine.size() != 2 || right.size() != 2) return false;
  const double larger = std::max(std::abs(right[0]), std::abs(right[1]));
  constexpr double few = 16;  // roundings
  return std::ranges::equal(mine, right,
                            [&](double x, double y) { return std::abs(x - y) <= few * unit * larger; });
}

}  // namespace

bool Examination::is_beyond_rounding(std::size_t i) const {
  constexpr double generous = 1024;  // times what plain methods lose, and a share of the scene
  const Known& known = failing_.at(i);
  if (!known.got) return false;
  const auto& [one, exact] = known.asked;
  const double unit = roundoff_of(one.precision);
  if (loses_the_smaller_root(*known.got, exact, unit)) return false;
  const oracle::Judgement judgement = oracle::judge(one, *known.got);
  const double lost = generous * judgement.far * judgement.far;
  const double error = judgement.wrong ? judgement.margin : judgement.residual;
  if (error > lost && error * unit * generous > 1) return true;
  const std::optional<Aspect> beside = detail_of(patient_.claim);
  if (beside == Aspect::normal)
    return error_of_normal(*known.got, exact) > std::max(lost * unit, 1 / generous);
  return beside && lost * unit * generous < 1 && !agree(one, *known.got, exact, *beside);
}

bool Examination::is_of_ordinary_size(std::size_t i) const {
  const auto& [one, exact] = failing_.at(i).asked;
  const auto is_ordinary = [](double x) {
    return x == 0 || !std::isfinite(x) || (0x1p-10 <= std::abs(x) && std::abs(x) <= 0x1p10);
  };
  bool are_all = true;
  each_number_of(one, [&](double x) { are_all = are_all && is_ordinary(x); });
  const RayQuestion* asked = ray_question(one);
  const double length = asked == nullptr ? 1 : glm::length(asked->ray.direction);
  for (const double t : numbers_in(exact)) are_all = are_all && is_ordinary(t) && is_ordinary(t * length);
  return are_all;
}

double Examination::error_of(std::size_t i) const {
  const Known& known = failing_.at(i);
  if (!known.got || std::holds_alternative<Position>(*known.got)) return HUGE_VAL;
  const std::vector<double> got = numbers_in(*known.got), exact = numbers_in(known.asked.exact);
  if (got.size() > exact.size() || got.empty() != exact.empty()) return HUGE_VAL;
  double worst = 0;
  for (std::size_t k = 0; k < got.size(); ++k)
    if (got[k] != exact[k]) worst = std::max(worst, std::abs(got[k] - exact[k]) / std::abs(exact[k]));
  return worst;
}

}  // namespace rayproof::diagnosis
