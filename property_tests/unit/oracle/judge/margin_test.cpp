/// \file
/// The judge's margins judged: a wrong verdict is excused only where an input within the band has another
/// verdict, and a search finds that input.

#include <algorithm>
#include <map>

#include "case/writer.hpp"
#include "oracle/numbers/ulp.hpp"
#include "properties/claims/promise.hpp"
#include "properties/numbers.hpp"
#include "unit/oracle/every_case.hpp"

namespace rayproof::oracle::test {
namespace {

/// What the verdict is about: how many hits, which kind of roots, or which place.
std::size_t verdict_of(const Case& one) {
  const auto verdict = []<class A>(const A& given) -> std::size_t {
    if constexpr (std::is_same_v<A, RayAnswer>)
      return given.hits.count;
    else if constexpr (std::is_same_v<A, Position>)
      return static_cast<std::size_t>(given);
    else
      return static_cast<std::size_t>(given.kind);
  };
  return std::visit(verdict, answer(one));
}

/// The exact answer with a wrong verdict in its place.
Answer spoilt(const Case& one) {
  Answer answer = oracle::answer(one);
  const auto spoil = []<class A>(A& given) {
    if constexpr (std::is_same_v<A, RayAnswer>)
      given.hits.count = given.hits.count == 0 ? 1 : 0;
    else if constexpr (std::is_same_v<A, Position>)
      given = given == Position::outside ? Position::inside : Position::outside;
    else
      given.kind = given.kind == RootKind::none ? RootKind::two : RootKind::none;
  };
  std::visit(spoil, answer);
  return answer;
}

/// How far each number of the case may move: a length by its share of the scene's size, a direction and a
/// coefficient by its share of its own.
std::vector<double> reach_of(Case one, double share) {
  const auto is_own = [&](std::string_view field) {
    const bool is_vector = field == "ray.direction" || field == "normal" || field == "edges" ||
                           (topic_of(one) == "plane" && (field == "u" || field == "v"));
    return is_vector || std::holds_alternative<Quadratic<double>>(one.question);
  };
  std::map<std::string_view, double> own;
  double size = 0;
  for (const auto& [field, value, plain] : numbers_of(one)) {
    if (!std::isfinite(*value)) continue;
    own[field] = std::max(own[field], std::abs(*value));
    if (!is_own(field) && !field.starts_with("ray.t_") && field != "d")
      size = std::max(size, std::abs(*value));
  }
  std::vector<double> reach;
  for (const auto& [field, value, plain] : numbers_of(one)) {
    double unit = is_own(field) ? own[field] : size;
    if (field.starts_with("ray.t_")) unit = std::abs(*value) + size / own["ray.direction"];
    if (field == "d") unit = std::abs(*value) + own["normal"] * size;
    reach.push_back(std::isfinite(*value) ? share * unit : 0);
  }
  return reach;
}

/// A search for an input whose numbers lie within `reach` of the case's and whose verdict is another one.
class VerdictSearch {
 public:
  VerdictSearch(const Case& one, double share)
      : given_(one), near_(one), reach_(reach_of(one, share)), verdict_(verdict_of(one)) {
    near_.precision = given_.precision = Precision::float64;  // holds the inputs between the floats
  }

  [[nodiscard]] bool finds_another_verdict() { return by_descent() || by_chance(); }

 private:
  [[nodiscard]] bool is_another() const { return verdict_of(near_) != verdict_; }

  /// One number after the other goes where the margin is least.
  bool by_descent() {
    std::vector<CaseNumber> from = numbers_of(given_), to = numbers_of(near_);
    double least = judge(near_, spoilt(near_)).margin;
    for (std::size_t i = 0; i < to.size(); ++i) {
      double best = *to[i].value;
      for (const double by : {-1.0, -0.5, -0.125, 0.125, 0.5, 1.0}) {
        *to[i].value = *from[i].value + by * reach_[i];
        if (is_another()) return true;
        const double margin = judge(near_, spoilt(near_)).margin;
        if (margin < least) {
          least = margin;
          best = *to[i].value;
        }
      }
      *to[i].value = best;
    }
    return false;
  }

  /// All numbers at once.
  bool by_chance() {
    Random random(2022);
    for (int trial = 0; trial < 20'000; ++trial) {
      std::vector<CaseNumber> from = numbers_of(given_), to = numbers_of(near_);
      for (std::size_t i = 0; i < to.size(); ++i)
        *to[i].value = *from[i].value + random.between(-100, 100) / 100.0 * reach_[i];
      if (is_another()) return true;
    }
    return false;
  }

  Case given_, near_;
  std::vector<double> reach_;
  std::size_t verdict_;
};

/// Whether chance would not find what lies within the interval: it is hardly more than a number.
bool is_slim(const Case& one) {
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  if (asked == nullptr) return false;
  const auto& [origin, direction, t_min, t_max] = asked->ray;
  return t_max - t_min < 0x1p-10 * (std::abs(t_min) + std::abs(t_max)) || t_max - t_min < 0x1p-100;
}

using Margin = EveryShape;
INSTANTIATE_TEST_SUITE_P(Of, Margin,
                         testing::Values("quadratic", "point_in_polygon", "plane", "triangle", "polygon",
                                         "sphere", "box", "parallelepiped", "cylinder"),
                         topic_name);

// Found, before it was mended, that a margin to the line of a side excused a wrong place beside the side (of
// a point in a polygon, no such input for 76 of 667), and that the planes of a solid and the volumes of a
// triangle excused as much; and, by polygons off the origin, that another axis of the projection was excused
// by products of places in place of edges (5 of 122). The search may go twice as far as the band: it moves
// numbers, and the bands are of lengths of vectors. Chance rarely finds the inputs beside a ray that runs in
// the plane of a polygon, or almost along it (there 5,000 trials were too few), or in the side of a cylinder.
TEST_P(Margin, OfAnExcusedVerdictHasAnInputOfAnotherVerdictWithinTheBand) {
  const double band = robust_bound(GetParam()).value();
  std::size_t excused = 0;
  std::vector<std::string> unexplained;
  for (const Family& family : families()) {
    if (family.topic != GetParam()) continue;
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
      const Case one = family.generate(seed, Precision::float32);
      if (is_transformed(one) || is_slim(one)) continue;
      const Judgement judgement = judge(one, spoilt(one));
      const bool is_in_domain =
          judgement.smallest >= -28 && judgement.largest <= 28 && judgement.far < 0x1p28;
      if (!is_in_domain || judgement.margin > band) continue;
      ++excused;
      if (!VerdictSearch(one, 2 * band * roundoff_of(one.precision)).finds_another_verdict())
        unexplained.push_back(family.name + " " + write_case(one));
    }
  }
  EXPECT_GT(excused, 150U);
  EXPECT_LE(100 * unexplained.size(), excused) << testing::PrintToString(unexplained);
}

}  // namespace
}  // namespace rayproof::oracle::test
