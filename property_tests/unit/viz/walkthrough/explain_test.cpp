#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "case/reader.hpp"
#include "viz/explain/case_report.hpp"
#include "viz/shapes/topics.hpp"

namespace rayproof::viz {
namespace {

Walkthrough walk(const char* line, const std::string& method) {
  const Case one = read_case(line);
  return recorded_walk(one, method).value();
}

constexpr const char* small_root = R"({"query":"quadratic","precision":"float32","a":1,"b":1000,"c":1})";
constexpr const char* near_double =
    R"({"query":"quadratic","precision":"float32","a":1.01,"b":2.02,"c":1.0099})";
constexpr const char* far_sphere =
    R"({"precision":"float32","ray":{"origin":[0.5,0.6,-10000],"direction":[0,0,1]},)"
    R"("shape":{"type":"sphere","center":[0,0,0],"radius":1}})";
constexpr const char* tame_sphere =
    R"({"ray":{"origin":[0,0,-5],"direction":[0,0,1]},"shape":{"type":"sphere","center":[0,0,0],"radius":1}})";

TEST(Explain, TheSmallRootLosesPrecisionInTheSumOfMinusBAndTheRoot) {
  const Walkthrough walkthrough = walk(small_root, "textbook");
  ASSERT_TRUE(walkthrough.decisive_loss);
  EXPECT_EQ(walkthrough.outcome, Faithfulness::inaccurate);
  EXPECT_EQ(walkthrough.decisive_loss->step, "Apply the quadratic formula");
  EXPECT_EQ(walkthrough.decisive_loss->formula, "−b + √D");
  EXPECT_EQ(walkthrough.decisive_loss->kind, "subtraction");
  EXPECT_EQ(walkthrough.decisive_loss->effect, "cancels");
}

TEST(Explain, ACitardauqDivisionByNoiseIsTracedToItsSubtraction) {
  EXPECT_EQ(walk(small_root, "citardauq").decisive_loss->formula, "−b + √D");
}

TEST(Explain, AFarSphereLosesPrecisionInTheDiscriminant) {
  for (const char* method : {"textbook", "printed_2ac"}) {
    const Walkthrough walkthrough = walk(far_sphere, method);
    ASSERT_TRUE(walkthrough.decisive_loss) << method;
    EXPECT_EQ(walkthrough.outcome, Faithfulness::flipped);
    EXPECT_EQ(walkthrough.decisive_loss->step, "Form the discriminant");
    EXPECT_EQ(walkthrough.decisive_loss->formula, "b·b − 4·a·c");
    EXPECT_EQ(walkthrough.decisive_loss->name, "D");
    EXPECT_GE(walkthrough.decisive_loss->bits_lost_here, 20);
  }
  EXPECT_EQ(walk(far_sphere, "half_b").decisive_loss->formula, "b·b − a·c");
}

TEST(Explain, ANearlyDoubleRootLosesPrecisionInTheDiscriminant) {
  for (const char* method : {"textbook", "citardauq_viete"}) {
    const Walkthrough walkthrough = walk(near_double, method);
    ASSERT_TRUE(walkthrough.decisive_loss) << method;
    EXPECT_EQ(walkthrough.decisive_loss->formula, "b·b − 4·a·c");
    EXPECT_EQ(walkthrough.decisive_loss->effect, "cancels");
  }
}

TEST(Explain, AStableMethodLosesNothing) {
  EXPECT_EQ(walk(small_root, "citardauq_viete").outcome, Faithfulness::faithful);
  EXPECT_EQ(walk(near_double, "kahan").outcome, Faithfulness::faithful);
  EXPECT_EQ(walk(far_sphere, "centred").outcome, Faithfulness::faithful);
  EXPECT_FALSE(walk(tame_sphere, "textbook").decisive_loss);
}

TEST(Explain, AnOverflowIsCalledAnOverflow) {
  const Walkthrough walkthrough =
      walk(R"({"query":"quadratic","precision":"float32","a":1,"b":1e20,"c":1})", "textbook");
  ASSERT_TRUE(walkthrough.decisive_loss);
  EXPECT_EQ(walkthrough.decisive_loss->effect, "overflows and loses");
  EXPECT_EQ(walkthrough.decisive_loss->formula, "b·b");
}

TEST(Explain, ATransformIsAStepOfItsOwn) {
  const Walkthrough walkthrough = walk(
      R"({"ray":{"origin":[0,0,-5],"direction":[0,0,1]},"shape":{"type":"sphere","center":[0,0,0],"radius":1},)"
      R"("transform":[[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]})",
      "centred");
  EXPECT_EQ(walkthrough.steps.front().title, "Take the ray into the sphere's own space");
  EXPECT_EQ(walkthrough.lo, 4);
}

TEST(Explain, TheConclusionBlamesTheFormulaWhereNoPrecisionIsLost) {
  const Case one = read_case(tame_sphere);
  RayAnswer exact{Contact::crossing};
  exact.hits.push_back(4);
  exact.hits.push_back(6);
  RayAnswer wrong{Contact::crossing};
  wrong.hits.push_back(4.0 / 24);
  wrong.hits.push_back(6.0 / 24);
  const CaseReport report{one, exact, "sphere/printed_2ac", wrong, recorded_walk(one, "printed_2ac")};
  EXPECT_NE(conclusion_of(report).find("the formula itself is at fault"), std::string::npos);
}

/// What is said of an answer whose method can't be recorded.
std::string conclusion_of_unrecorded(const char* line, const Answer& exact, const Answer& claimed) {
  return conclusion_of(CaseReport{read_case(line), exact, "sphere/compensated", claimed});
}

TEST(Explain, AnAnswerWithoutStepsIsCalledWhatItsNumbersAre) {
  RayAnswer hit{Contact::crossing};
  hit.hits.push_back(4);
  const RayAnswer miss{};
  const std::string unrecorded = "sphere/compensated can't be recorded step by step; its answer is ";
  RayAnswer near_hit{Contact::crossing};
  near_hit.hits.push_back(std::nextafter(std::nextafter(4.0, 5.0), 5.0));
  EXPECT_EQ(conclusion_of_unrecorded(tame_sphere, hit, hit),
            unrecorded + "the exact one, correctly rounded.");
  EXPECT_EQ(conclusion_of_unrecorded(tame_sphere, hit, near_hit), unrecorded + "off by 2 ulps.");
  EXPECT_EQ(conclusion_of_unrecorded(tame_sphere, miss, miss), unrecorded + "the exact one.");
  EXPECT_EQ(conclusion_of_unrecorded(tame_sphere, Position::inside, Position::inside),
            unrecorded + "the exact one.");
  EXPECT_EQ(conclusion_of_unrecorded(small_root, QuadraticAnswer<double>{}, QuadraticAnswer<double>{}),
            unrecorded + "the exact one.");
  EXPECT_EQ(conclusion_of_unrecorded(tame_sphere, hit, miss), unrecorded + "not the exact one.");
}

TEST(Explain, TheJsonHoldsStepsValuesAndTheDecisiveLoss) {
  const Case one = read_case(small_root);
  const CaseReport report{one, QuadraticAnswer<double>{}, "quadratic/textbook", QuadraticAnswer<double>{},
                          recorded_walk(one, "textbook")};
  const auto json = nlohmann::json::parse(explain_json(report));
  EXPECT_EQ(json["decisive_loss"]["formula"], "−b + √D");
  EXPECT_EQ(json["steps"][0]["values"][0]["name"], "D");
  const std::string meaning = json["steps"][0]["meaning"];
  EXPECT_EQ(meaning,
            "Where a is not 0, the sign of D gives the number of real roots: two for D > 0, one for D = 0, "
            "none for D < 0.");
  EXPECT_NE(explain_text(report).find("1. Form the discriminant\n   " + meaning + "\n   D  "),
            std::string::npos);
  EXPECT_EQ(json["inputs"].size(), 3U);
}

}  // namespace
}  // namespace rayproof::viz
