#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "case/reader.hpp"
#include "viz/told.hpp"
#include "viz/topics.hpp"

namespace rayproof::viz {
namespace {

Walkthrough walk(const char* line, const std::string& method) {
  const Case one = read_case(line);
  return view_of(one)->walk(one, method).value();
}

constexpr const char* small_root = R"({"query":"quadratic","precision":"float32","a":1,"b":1000,"c":1})";
constexpr const char* near_double =
    R"({"query":"quadratic","precision":"float32","a":1.01,"b":2.02,"c":1.0099})";
constexpr const char* far_sphere =
    R"({"precision":"float32","ray":{"origin":[0.5,0.6,-10000],"direction":[0,0,1]},)"
    R"("shape":{"type":"sphere","center":[0,0,0],"radius":1}})";
constexpr const char* tame_sphere =
    R"({"ray":{"origin":[0,0,-5],"direction":[0,0,1]},"shape":{"type":"sphere","center":[0,0,0],"radius":1}})";

TEST(Explain, TheSmallRootDiesInTheSumOfMinusBAndTheRoot) {
  const Walkthrough told = walk(small_root, "textbook");
  ASSERT_TRUE(told.death);
  EXPECT_EQ(told.outcome, Outcome::inaccurate);
  EXPECT_EQ(told.death->step, "Apply the quadratic formula");
  EXPECT_EQ(told.death->formula, "−b + √D");
  EXPECT_EQ(told.death->kind, "subtraction");
  EXPECT_EQ(told.death->effect, "cancels");
}

TEST(Explain, ACitardauqDivisionByNoiseIsTracedToItsSubtraction) {
  EXPECT_EQ(walk(small_root, "citardauq").death->formula, "−b + √D");
}

TEST(Explain, AFarSphereDiesInTheDiscriminant) {
  for (const char* method : {"textbook", "printed_2ac"}) {
    const Walkthrough told = walk(far_sphere, method);
    ASSERT_TRUE(told.death) << method;
    EXPECT_EQ(told.outcome, Outcome::flipped);
    EXPECT_EQ(told.death->step, "Form the discriminant");
    EXPECT_EQ(told.death->formula, "b·b − 4·a·c");
    EXPECT_EQ(told.death->name, "D");
    EXPECT_GE(told.death->bits_lost_here, 20);
  }
  EXPECT_EQ(walk(far_sphere, "half_b").death->formula, "b·b − a·c");
}

TEST(Explain, ANearlyDoubleRootDiesInTheDiscriminant) {
  for (const char* method : {"textbook", "citardauq_viete"}) {
    const Walkthrough told = walk(near_double, method);
    ASSERT_TRUE(told.death) << method;
    EXPECT_EQ(told.death->formula, "b·b − 4·a·c");
    EXPECT_EQ(told.death->effect, "cancels");
  }
}

TEST(Explain, AStableMethodLosesNothing) {
  EXPECT_EQ(walk(small_root, "citardauq_viete").outcome, Outcome::faithful);
  EXPECT_EQ(walk(near_double, "kahan").outcome, Outcome::faithful);
  EXPECT_EQ(walk(far_sphere, "centred").outcome, Outcome::faithful);
  EXPECT_FALSE(walk(tame_sphere, "textbook").death);
}

TEST(Explain, AnOverflowIsCalledAnOverflow) {
  const Walkthrough told =
      walk(R"({"query":"quadratic","precision":"float32","a":1,"b":1e20,"c":1})", "textbook");
  ASSERT_TRUE(told.death);
  EXPECT_EQ(told.death->effect, "overflows and loses");
  EXPECT_EQ(told.death->formula, "b·b");
}

TEST(Explain, ATransformIsAStepOfItsOwn) {
  const Walkthrough told = walk(
      R"({"ray":{"origin":[0,0,-5],"direction":[0,0,1]},"shape":{"type":"sphere","center":[0,0,0],"radius":1},)"
      R"("transform":[[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]})",
      "centred");
  EXPECT_EQ(told.steps.front().title, "Take the ray into the sphere's own space");
  EXPECT_EQ(told.lo, 4);
}

TEST(Explain, TheConclusionBlamesTheFormulaWhereNoDigitsDied) {
  const Case one = read_case(tame_sphere);
  RayAnswer exact{Contact::crossing};
  exact.hits.push_back(4);
  exact.hits.push_back(6);
  RayAnswer wrong{Contact::crossing};
  wrong.hits.push_back(4.0 / 24);
  wrong.hits.push_back(6.0 / 24);
  const Told told{one, exact, "sphere/printed_2ac", wrong, view_of(one)->walk(one, "printed_2ac")};
  EXPECT_NE(conclusion_of(told).find("the formula itself is at fault"), std::string::npos);
}

/// What is said of an answer whose method can't be recorded.
std::string conclusion_of_unrecorded(const char* line, const Answer& exact, const Answer& claimed) {
  return conclusion_of(Told{read_case(line), exact, "sphere/compensated", claimed});
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

TEST(Explain, TheJsonHoldsStepsValuesAndTheDeath) {
  const Case one = read_case(small_root);
  const Told told{one, QuadraticAnswer<double>{}, "quadratic/textbook", QuadraticAnswer<double>{},
                  view_of(one)->walk(one, "textbook")};
  const auto json = nlohmann::json::parse(explain_json(told));
  EXPECT_EQ(json["death"]["formula"], "−b + √D");
  EXPECT_EQ(json["steps"][0]["values"][0]["name"], "D");
  const std::string meaning = json["steps"][0]["meaning"];
  EXPECT_EQ(meaning,
            "Its sign gives the number of real roots: two for D > 0, one for D = 0, none for D < 0.");
  EXPECT_NE(explain_text(told).find("1. Form the discriminant\n   " + meaning + "\n   D  "),
            std::string::npos);
  EXPECT_NE(html_page(told).find("<p>Its sign gives the number of real roots"), std::string::npos);
  EXPECT_EQ(json["inputs"].size(), 3U);
}

}  // namespace
}  // namespace rayproof::viz
