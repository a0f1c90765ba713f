/// \file
/// The guaranteed method against the exact quadric. RAYPROOF_QUADRIC_RAYS sets the number of rays for each
/// precision (7,000 where it is not set); docs/surfaces.md has the figures of a million.

#include "oracle/shapes/quadric.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <rayproof/implicit/roots.hpp>

#include "unit/oracle/quadric_rays.hpp"

namespace rayproof::oracle::test {
namespace {

constexpr double inf = infinity<double>;

SolvedEquation unit_sphere(const glm::dvec3& origin, const glm::dvec3& direction) {
  return oracle::meet({origin, direction}, {.xx = 1, .yy = 1, .zz = 1, .ww = -1});
}

TEST(QuadricOracle, CrossesTheUnitSphereAtFourAndSix) {
  const SolvedEquation line = unit_sphere({0, 0, -5}, {0, 0, 1});
  EXPECT_EQ(line.kind, RootKind::two);
  ASSERT_EQ(line.roots.size(), 2U);
  EXPECT_EQ(line.roots[0].compare(Ring(4.0)), 0);
  EXPECT_EQ(line.roots[1].compare(Ring(6.0)), 0);
}

TEST(QuadricOracle, DistinguishesATangentFromItsNeighbours) {
  const double above = std::nextafter(1.0, 2.0), below = std::nextafter(1.0, 0.0);
  EXPECT_EQ(unit_sphere({0, 1, -5}, {0, 0, 1}).kind, RootKind::twice);
  EXPECT_EQ(unit_sphere({0, above, -5}, {0, 0, 1}).kind, RootKind::none);
  EXPECT_EQ(unit_sphere({0, below, -5}, {0, 0, 1}).kind, RootKind::two);
}

TEST(QuadricOracle, MeetsAConeOnceAlongAnAsymptote) {
  const implicit::Quadric<double> cone{.xx = 1, .yy = 1, .zz = -1};
  const SolvedEquation line = oracle::meet({{3, 0, -1}, {0, 3, 3}}, cone);
  EXPECT_EQ(line.kind, RootKind::linear);
  ASSERT_EQ(line.roots.size(), 1U);  // 9 + 9t² - (3t - 1)² = 0
  EXPECT_EQ(line.roots[0].affine_image(Ring(0.0), Ring(3.0)).compare(Ring(-4.0)), 0);
}

TEST(QuadricOracle, KnowsARulingOfAHyperboloid) {
  const implicit::Quadric<double> hyperboloid{.xx = 1, .yy = 1, .zz = -1, .ww = -1};
  EXPECT_EQ(oracle::meet({{1, 0, 0}, {0, 1, 1}}, hyperboloid).kind, RootKind::everything);
  EXPECT_EQ(oracle::meet({{0, 0, 0}, {0, 1, 1}}, hyperboloid).kind, RootKind::constant);
}

TEST(QuadricOracle, TakesMixedTermsOnce) {
  const SolvedEquation line = oracle::meet({{2, 0, 0}, {0, 1, 0}}, {.xy = 1, .ww = -6});  // xy = 6 at x = 2
  EXPECT_EQ(line.kind, RootKind::linear);
  EXPECT_EQ(line.roots[0].compare(Ring(3.0)), 0);
}

TEST(QuadricOracle, CatchesEveryWayToBeWrong) {
  const Ray<double> ray{{0, 0, -5}, {0, 0, 1}};
  const implicit::Quadric<double> sphere{.xx = 1, .yy = 1, .zz = 1, .ww = -1};
  const auto judged = [&](const EnclosedRoots<double>& claimed) {
    return judge(ray, sphere, Precision::float64, claimed);
  };
  using enum RootStatus;
  EXPECT_TRUE(judged({{4, 4, certain}, {5.5, 6.5, undecided}}).is_right());
  EXPECT_TRUE(judged({{4, 4, certain}}).has_missed);
  EXPECT_TRUE(judged({{4, 6, certain}}).is_wrong_certain);
  EXPECT_TRUE(judged({{3, 5, certain}, {5, 5.5, certain}, {6, 6, certain}}).is_wrong_certain);
  EXPECT_TRUE(judged({{0, inf, everywhere}}).is_wrong_everywhere);
  EXPECT_FALSE(judged({{5.5, 6.5, certain}, {3, 4.5, certain}}).is_ordered);
  EXPECT_FALSE(judged({{-1, 5, certain}, {6, 6, certain}}).is_ordered);
  EXPECT_EQ(judged({{0, 1, undecided}, {4, 4, certain}, {6, 6, certain}}).idle, 1U);
}

/// What a family has come to.
struct FamilyCounts {
  std::size_t rays = 0, known = 0, tangents = 0, certain = 0, narrow = 0, idle = 0, evaluations = 0,
              spent = 0;
  double widest = 0, overrun = 0;
};

EnclosedRoots<double> widened(const EnclosedRoots<float>& roots) {
  EnclosedRoots<double> wide;
  for (const auto& one : roots) wide.push_back({one.lo, one.hi, one.status});
  return wide;
}
const EnclosedRoots<double>& widened(const EnclosedRoots<double>& roots) { return roots; }

template <class T>
implicit::Quadric<double> widened(const implicit::Quadric<T>& q) {
  return {q.xx, q.yy, q.zz, q.yz, q.xz, q.xy, q.xw, q.yw, q.zw, q.ww};
}

template <class T>
void put(const QuadricScene<T>& scene, FamilyCounts& tally, std::size_t budget = default_budget) {
  constexpr Precision precision = sizeof(T) == 4 ? Precision::float32 : Precision::float64;
  const implicit::Search<T> found = implicit::search(scene.ray, scene.quadric, budget);
  const EnclosureJudgement judgement =
      judge(convert<double>(scene.ray), widened(scene.quadric), precision, widened(found.roots));
  EXPECT_LE(judgement.has_missed ? 1 : 0, search_contract.missed.promised);
  EXPECT_LE(judgement.is_wrong_certain ? 1 : 0, search_contract.wrong.promised);
  EXPECT_FALSE(judgement.is_wrong_everywhere);
  EXPECT_TRUE(judgement.is_ordered);
  const double overrun = static_cast<double>(found.evaluations) - 2 * static_cast<double>(budget);
  EXPECT_LE(overrun, search_contract.overrun.promised);
  tally.overrun = std::max(tally.overrun, overrun);
  ++tally.rays;
  tally.known += judgement.known;
  tally.tangents += judgement.tangents;
  tally.certain += judgement.certain;
  tally.narrow += judgement.narrow;
  tally.idle += judgement.idle;
  tally.evaluations += found.evaluations;
  tally.spent = std::max(tally.spent, found.evaluations);
  tally.widest = std::max(tally.widest, judgement.widest);
}

std::uint64_t ray_count() {
  const char* const set = std::getenv("RAYPROOF_QUADRIC_RAYS");
  return set == nullptr ? 7'000 : std::strtoull(set, nullptr, 10);
}

template <class T>
class GuaranteedRoots : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(GuaranteedRoots, Precisions);

TYPED_TEST(GuaranteedRoots, HoldEveryRootTheExactQuadricKnows) {
  fmt::print("{:<14}{:>9}{:>9}{:>10}{:>9}{:>9}{:>11}{:>9}{:>11}{:>7}{:>12}\n", "family", "rays", "roots",
             "tangents", "certain", "<=64 ulp", "undecided", "no root", "evals/ray", "most", "widest/ulp");
  const std::uint64_t each = ray_count() / quadric_families<TypeParam>.size() + 1;
  for (const auto& family : quadric_families<TypeParam>) {
    FamilyCounts tally;
    for (std::uint64_t seed = 0; seed < each && !this->HasFailure(); ++seed) {
      SCOPED_TRACE(fmt::format("{} {}", family.name, seed));
      Random random(combine(seed, 2022));
      put(family.draw(random), tally);
    }
    const double evaluations = static_cast<double>(tally.evaluations) / static_cast<double>(tally.rays);
    fmt::print("{:<14}{:>9}{:>9}{:>10}{:>9}{:>9}{:>11}{:>9}{:>11.1f}{:>7}{:>12.3g}\n", family.name,
               tally.rays, tally.known, tally.tangents, tally.certain, tally.narrow,
               tally.known - tally.certain, tally.idle, evaluations, tally.spent, tally.widest);
    std::fflush(stdout);  // a million rays take minutes
  }
}

TYPED_TEST(GuaranteedRoots, AreHeldWhateverTheBudget) {
  FamilyCounts tally;
  for (const std::size_t budget : {0U, 1U, 2U, 5U, 20U, 80U}) {
    for (const auto& family : quadric_families<TypeParam>) {
      for (std::uint64_t seed = 0; seed < 300 && !this->HasFailure(); ++seed) {
        SCOPED_TRACE(fmt::format("{} {}, budget {}", family.name, seed, budget));
        Random random(combine(seed, 2022));
        put(family.draw(random), tally, budget);
      }
    }
  }
  EXPECT_GT(tally.overrun, 0) << "no budget was spent";
  fmt::print("{} evaluations of f beyond twice the budget\n", tally.overrun);
}

/// Ray 9041 of the wild family in float: two roots, each certain in 1/t, became one certain root where both
/// are too large for a float.
TEST(GuaranteedRootsBeyondTheGreatestFloat, AreNotTakenForOne) {
  const QuadricScene<float> scene{
      {{0x1.4744e2p+14F, -0x1.16e862p+112F, 0x1.ce7e68p-57F}, {0x1.d98be6p-96F, -0x1p-109F, 0x1.8p+1F}},
      {-0x1.adf92ap+56F, -1, -0x1p-88F, 0x1.ac2026p-42F, 0x1.3ee22ap-79F, -0x1.165a6p+72F, -0x1.5a34a6p+40F,
       0x1.5536dcp+1F, -0x1.59a9ecp-51F, 12}};
  FamilyCounts tally;
  put(scene, tally);
  EXPECT_EQ(tally.known, 2U);
  EXPECT_EQ(tally.certain, 0U);
}

}  // namespace
}  // namespace rayproof::oracle::test
