#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "case/reader.hpp"
#include "oracle/oracle.hpp"
#include "unit/diagnosis/clinic.hpp"
#include "unit/diagnosis/faulty/faulty.hpp"
#include "unit/diagnosis/marks.hpp"

namespace rayproof::faulty {
namespace {

RayAnswer hit_at(double t) {
  RayAnswer answer = with_hits({t});
  answer.nearest_only = true;
  return answer;
}

constexpr const char* along_a_diagonal =
    R"({"ray": {"origin": [0.5,-2,-2], "direction": [0,1,1]}, "shape": {"type": "box", "min": [0,0,0], "max": [1,1,1]}})";
constexpr const char* through_the_middle =
    R"({"ray": {"origin": [0.5,0.5,-2], "direction": [0,0,1]}, "shape": {"type": "box", "min": [0,0,0], "max": [1,1,1]}})";

TEST(DiagnosisOfEdges, KnowsABoxWhoseEdgesAreRoundedOff) {
  // The edge x = y = 0 rounded off with a radius of 0.04 is 0.04 (1 - 1/√2) behind both faces.
  const double behind = 0.04 * (1 - std::sqrt(0.5));
  EXPECT_EQ(bears("rounded-edges", along_a_diagonal, hit_at(2 + behind)), true);
  EXPECT_EQ(bears("rounded-edges", along_a_diagonal, hit_at(2)), std::nullopt) << "that is right";
  EXPECT_EQ(bears("rounded-edges", along_a_diagonal, hit_at(2.2)), false) << "no radius is so large";
  EXPECT_EQ(bears("rounded-edges", along_a_diagonal, hit_at(1.9)), false) << "it lies before the box";
  EXPECT_EQ(bears("rounded-edges", through_the_middle, hit_at(2 + behind)), false);
  const char* const beside_an_edge =
      R"({"ray": {"origin": [0.5,-0.99,1], "direction": [0,1,-1]}, "shape": {"type": "box", "min": [0,0,0], "max": [1,1,1]}})";
  EXPECT_EQ(bears("rounded-edges", beside_an_edge, RayAnswer{}), true);
  EXPECT_EQ(bears("rounded-edges", through_the_middle, RayAnswer{}), false);
}

TEST(DiagnosisOfEdges, KnowsACylinderWhoseRimsAreRoundedOff) {
  const char* const at_rim =
      R"({"ray": {"origin": [-2,0,-1], "direction": [1,0,1]}, "shape": {"type": "cylinder", "rx": 1, "ry": 1, "height": 1, "capped": true}})";
  const double behind = 0.1 * (1 - std::sqrt(0.5));
  EXPECT_EQ(bears("rounded-edges", at_rim, hit_at(1 + behind)), true);
  EXPECT_EQ(bears("rounded-edges", at_rim, hit_at(1)), std::nullopt) << "that is right";
  EXPECT_EQ(bears("rounded-edges", at_rim, hit_at(1.2)), false) << "no radius is so large";
  const char* const elliptic =
      R"({"ray": {"origin": [-3,0,-1], "direction": [1,0,1]}, "shape": {"type": "cylinder", "rx": 2, "ry": 1, "height": 1, "capped": true}})";
  EXPECT_EQ(bears("rounded-edges", elliptic, hit_at(1 + behind)), std::nullopt);
}

TEST(DiagnosisOfEdges, KnowsASearchThatEndsBeforeTheSurface) {
  const char* const sphere =
      R"({"ray": {"origin": [0,0,-2], "direction": [0,0,0.5]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})";
  EXPECT_EQ(bears("stops-before-1e-3", sphere, hit_at(2 - 0.0019)), true) << "0.00095 before it";
  EXPECT_EQ(bears("stops-before-1e-3", sphere, hit_at(2 - 0.0021)), false) << "0.00105 before it";
  EXPECT_EQ(bears("stops-before-1e-2", sphere, hit_at(2 - 0.0021)), true);
  EXPECT_EQ(bears("stops-before-1e-2", sphere, hit_at(2)), std::nullopt) << "that is right";
  EXPECT_EQ(bears("stops-before-1e-2", sphere, hit_at(2 + 0.001)), std::nullopt) << "it lies behind it";
  EXPECT_EQ(bears("stops-before-1e-2", sphere, RayAnswer{}), std::nullopt);
  const char* const beside =
      R"({"ray": {"origin": [0,1.005,-2], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})";
  EXPECT_EQ(bears("stops-before-1e-2", beside, hit_at(2)), true) << "the sphere is missed by 0.005";
  EXPECT_EQ(bears("stops-before-1e-3", beside, hit_at(2)), false);
}

TEST(DiagnosisOfEdges, KnowsASolidThatIsMissedThroughAnEdgeOrARim) {
  const char* const at_rim =
      R"({"ray": {"origin": [-2,0,-1], "direction": [1,0,1]}, "shape": {"type": "cylinder", "rx": 1, "ry": 1, "height": 1, "capped": true}})";
  EXPECT_EQ(bears("missed-through-edge", along_a_diagonal, RayAnswer{}), true);
  EXPECT_EQ(bears("missed-through-edge", at_rim, RayAnswer{}), true);
  EXPECT_EQ(bears("missed-through-edge", along_a_diagonal, hit_at(2)), std::nullopt);
  EXPECT_EQ(bears("missed-through-edge", through_the_middle, RayAnswer{}), false);
  const char* const touching =
      R"({"ray": {"origin": [0.5,-1,1], "direction": [0,1,-1]}, "shape": {"type": "box", "min": [0,0,0], "max": [1,1,1]}})";
  const char* const in_a_face =
      R"({"ray": {"origin": [0,0.5,-2], "direction": [0,0,1]}, "shape": {"type": "box", "min": [0,0,0], "max": [1,1,1]}})";
  EXPECT_EQ(bears("missed-through-edge", touching, RayAnswer{}), false);
  EXPECT_EQ(bears("missed-through-edge", in_a_face, RayAnswer{}), false);
}

TEST(DiagnosisOfEdges, KnowsABoxOfARoundedCentre) {
  // 5000000 + 4038432.25 is rounded to whole numbers in float32: the box then begins at -4999999.875.
  const char* const in_its_face =
      R"({"precision": "float32", "ray": {"origin": [0,-5000000,0], "direction": [1,0,0]}, "shape": {"type": "box", "min": [1,-5000000,0], "max": [9,-4038432.25,1]}})";
  EXPECT_EQ(bears("rounded-centre", in_its_face, RayAnswer{}), true);
  EXPECT_EQ(bears("rounded-centre", in_its_face, hit_at(1)), std::nullopt);
  EXPECT_EQ(bears("rounded-centre", through_the_middle, RayAnswer{}), std::nullopt);
}

TEST(DiagnosisOfEdges, KnowsARayWhoseOriginIsRoundedAsItIsSeenFromABoxsMiddle) {
  // 0.5 - 0.0001 is rounded by 1.1e-17, more than the last digit of t.
  const char* const beside_a_face =
      R"({"ray": {"origin": [0,0,0.0001], "direction": [0,0,-1]}, "shape": {"type": "box", "min": [0,0,0], "max": [1,1,1]}})";
  EXPECT_EQ(bears("rounded-centre", beside_a_face, hit_at(0.5 - (0.5 - 0.0001))), true);
  EXPECT_EQ(bears("rounded-centre", beside_a_face, hit_at(0.0001)), std::nullopt) << "that is right";
  EXPECT_EQ(bears("rounded-centre", beside_a_face, hit_at(0.0002)), std::nullopt) << "that is no rounding";
}

TEST(DiagnosisOfDirections, TakesAwayWhatIsTinyBesideTheRest) {
  const Change change = find_hypothesis("without-tiny-component")->change;
  const char* const tiny =
      R"({"ray": {"origin": [-0.1,1,-0.25], "direction": [-2.8e-17,-1,1.5]}, "shape": {"type": "plane", "normal": [0,0,1], "d": 0}})";
  const std::vector<Case> changed = change(read_case(tiny));
  ASSERT_EQ(changed.size(), 1U);
  EXPECT_EQ(std::get<RayQuestion>(changed.front().question).ray.direction, glm::dvec3(0, -1, 1.5));
  EXPECT_TRUE(change(read_case(along_a_diagonal)).empty());
  // In the object's space y of the direction is 2e-9.
  const char* const tiny_in_object =
      R"({"ray": {"origin": [0,0,1], "direction": [1,1,-1]}, "shape": {"type": "plane", "normal": [0,0,1], "d": 0}, "transform": [[1,0,0,0],[0.999999998,1,0,0],[0,0,1,0],[0,0,0,1]]})";
  const std::vector<Case> in_object = change(read_case(tiny_in_object));
  ASSERT_EQ(in_object.size(), 1U);
  EXPECT_EQ(std::get<RayQuestion>(in_object.front().question).ray.direction, glm::dvec3(1, 0, -1));
}

TEST(DiagnosisOfIntervals, MovesAnEndAloneThatAHitLiesOn) {
  const Change change = find_hypothesis("off-interval-ends")->change;
  const char* const at_t_max =
      R"({"ray": {"origin": [0,0,1], "direction": [0,0,-1], "t_min": 0, "t_max": 1}, "shape": {"type": "plane", "normal": [0,0,1], "d": 0}})";
  ASSERT_EQ(change(read_case(at_t_max)).size(), 1U);
  EXPECT_GT(std::get<RayQuestion>(change(read_case(at_t_max)).front().question).ray.t_max, 1);
  EXPECT_TRUE(change(read_case(along_a_diagonal)).empty()) << "it hits at t = 2, far from both ends";
}

/// "range: ignores-t-min": what is found wrong with a sphere's verdicts, each cause once.
template <Fault fault>
std::set<std::string> kinds_and_causes() {
  std::set<std::string> found;
  const Subject subject = subject_of("sphere", answer<fault>);
  for (const Diagnosis& group : faults_of(subject, *find_property("verdict"), Precision::float64, 100))
    found.insert(std::string(name_of(group.kind)) + ": " +
                 std::string(group.cause ? group.cause->name : "none"));
  return found;
}

TEST(DiagnosisOfSizes, CallsAFaultOneOfRangeThatNoOrdinarySizeShows) {
  EXPECT_EQ(kinds_and_causes<Fault::limited>(), std::set<std::string>{"range: limit-1e5"});
  EXPECT_EQ(kinds_and_causes<Fault::ignores_t_min>(), std::set<std::string>{"gross: ignores-t-min"});
}

/// Wrong about points as soon as a vertex is far off, as products of 32 bits are.
Answer position_in_few_bits(const Case& one) {
  const auto right = std::get<Position>(oracle::answer(one));
  const auto& vertices = std::get<PointAndPolygon<double>>(one.question).vertices;
  const bool overflows = std::ranges::any_of(
      vertices, [](const auto& vertex) { return std::max(std::abs(vertex.x), std::abs(vertex.y)) > 46340; });
  if (!overflows) return right;
  return right == Position::outside ? Position::inside : Position::outside;
}

TEST(DiagnosisOfSizes, SpeaksOfNoDirectionWhereAPointHasNone) {
  const Subject subject = subject_of("point_in_polygon", position_in_few_bits);
  const auto groups = faults_of(subject, *find_property("verdict"), Precision::float64, 100);
  ASSERT_FALSE(groups.empty());
  EXPECT_EQ(in_words(groups).substr(0, 14), "smaller-scene ");
  EXPECT_EQ(groups.front().sentence,
            "right as soon as the numbers are smaller: a fixed largest number, or products that overflow");
}

TEST(DiagnosisOfSizes, MakesNoSceneSoSmallThatItsNumbersVanish) {
  for (const auto& [precision, scenes] :
       {std::pair(Precision::float32, 4U), std::pair(Precision::float64, 5U)}) {
    const Case one{.precision = precision,
                   .question = PointAndPolygon<double>{{3, 4}, {{3, 4}, {-4, 4}, {1, -4}}}};
    const std::vector<Case> smaller = find_hypothesis("smaller-scene")->change(one);
    EXPECT_EQ(smaller.size(), scenes) << name_of(precision) << ": by 2^-200 no float is left";
    for (const Case& other : smaller) EXPECT_NE(std::get<PointAndPolygon<double>>(other.question).point.x, 0);
  }
}

}  // namespace
}  // namespace rayproof::faulty
