/// \file
/// What explanations and walkthroughs say of random cases is what their numbers are.

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>
#include <cstdlib>
#include <functional>

#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "unit/viz/stage_data.hpp"
#include "viz/explain/case_report.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
namespace {

using Decimal = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<900>>;

/// Random cases of every family in both precisions, each by every method of its topic.
void for_answered_cases(std::uint64_t seeds, const std::function<void(const CaseReport&)>& check) {
  for (const Family& family : families()) {
    for (const Subject& subject : subjects()) {
      if (subject.topic != family.topic) continue;
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        for (const Precision precision : {Precision::float32, Precision::float64})
          check(report_of(family.generate(seed, precision), &subject));
      }
    }
  }
}

bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

std::string few_ulps(double ulps) {
  return std::to_string(static_cast<int>(ulps)) + (ulps == 1 ? " ulp" : " ulps");
}

bool are_equal(const CaseReport& report) {
  return !verdicts_differ(&report.exact, report.claim()) &&
         worst_ulps(&report.exact, report.claim(), report.one.precision) == 0;
}

TEST(TrueSentences, TheConclusionAgreesWithTheCountAboveIt) {
  std::size_t rounded = 0;
  std::size_t off = 0;
  for_answered_cases(2, [&](const CaseReport& report) {
    const std::string text = explain_text(report);
    const std::string conclusion = conclusion_of(report);
    SCOPED_TRACE(report.method + " " + write_case(report.one) + "\n" + conclusion);
    const bool is_off = says(text.substr(0, text.size() - conclusion.size() - 1), " is off by ");
    if (is_off) {
      EXPECT_FALSE(says(conclusion, "is the exact one"));
    }
    if (are_equal(report)) {
      ++rounded;
      EXPECT_FALSE(is_off);
      EXPECT_TRUE(says(conclusion, "answer is the exact one"));
    }
    if (says(conclusion, "The answer is within")) {
      ++off;
      const double ulps = worst_ulps(&report.exact, report.claim(), report.one.precision);
      EXPECT_TRUE(says(conclusion,
                       "The answer is within " + few_ulps(ulps) + " of the exact one, correctly rounded."));
      EXPECT_TRUE(says(text, "off by " + few_ulps(ulps)));
    }
  });
  EXPECT_GT(rounded, 100U);
  EXPECT_GT(off, 100U);
}

TEST(TrueSentences, AWalkthroughCallsEqualOnlyWhatIsEqual) {
  std::size_t equal = 0;
  std::size_t different = 0;
  for_answered_cases(1, [&](const CaseReport& report) {
    const StageStep last = stage_of(report).steps.back();
    SCOPED_TRACE(report.method + " " + write_case(report.one) + "\n" + last.caption);
    const bool is_called_equal =
        says(last.caption, "are the same") || says(last.caption, "is the exact one, correctly rounded");
    EXPECT_EQ(is_called_equal, are_equal(report));
    ++(is_called_equal ? equal : different);
  });
  EXPECT_GT(equal, 100U);
  EXPECT_GT(different, 100U);
}

TEST(TrueSentences, TwoDoublesOneUlpApartAreNotCalledEqual) {
  const Case one = read_case(
      R"({"ray":{"origin":[0,0,-5],"direction":[0,0,1]},"shape":{"type":"sphere","center":[0,0,0],"radius":1}})");
  CaseReport report = report_of(one, "sphere/centred");
  std::get<RayAnswer>(*report.claimed).hits.t[0] = std::nextafter(4.0, 5.0);
  EXPECT_TRUE(says(stage_of(report).steps.back().caption, "off by 1 ulp"))
      << stage_of(report).steps.back().caption;
  EXPECT_TRUE(says(conclusion_of(report), "within 1 ulp of")) << conclusion_of(report);
}

TEST(TrueSentences, AnInfiniteAnswerForAFiniteOneIsNotPassedOver) {
  const Case one = read_case(
      R"({"ray":{"origin":[0,0,-5],"direction":[0,0,1]},"shape":{"type":"sphere","center":[0,0,0],"radius":1}})");
  CaseReport report = report_of(one, "sphere/centred");
  std::get<RayAnswer>(*report.claimed).hits.t[1] = INFINITY;
  EXPECT_TRUE(says(stage_of(report).steps.back().caption, "The computed t₁ is infinitely far off"))
      << stage_of(report).steps.back().caption;
}

TEST(TrueSentences, AnExactNumberReadsAsTheRoundedOneOnlyWhereItIsThatNumber) {
  std::size_t rounded = 0;
  const auto check = [&](const WalkValue& v, Precision precision) {
    if (!std::isfinite(v.value) || !std::isfinite(v.error)) return;
    SCOPED_TRACE(v.name + ": " + v.exact + " beside " + shown(v.value, precision));
    const Decimal written(v.exact);
    if (v.error == 0) {
      EXPECT_EQ(std::strtod(v.exact.c_str(), nullptr), v.value);
      return;
    }
    ++rounded;
    EXPECT_NE(v.exact, shown(v.value, precision));
    const Decimal exact = Decimal(v.value) - Decimal(v.error);
    // Half of the last digit, and the rounding of the error itself to double.
    const Decimal half_a_digit(precision == Precision::float32 ? "5.1e-12" : "5.1e-17");
    EXPECT_LE(abs(written - exact), abs(exact) * half_a_digit + abs(Decimal(v.error)) * Decimal("1.2e-16"));
  };
  for_answered_cases(1, [&](const CaseReport& report) {
    if (!report.walk) return;
    SCOPED_TRACE(report.method + " " + write_case(report.one));
    for (const WalkValue& value : report.walk->inputs) check(value, report.one.precision);
    for (const WalkStep& step : report.walk->steps) {
      for (const WalkValue& value : step.values) check(value, report.one.precision);
    }
  });
  EXPECT_GT(rounded, 1000U);
}

TEST(TrueSentences, InputsAreShownAsTheyAreStored) {
  const Case one = read_case(R"({"precision":"float32","ray":{"origin":[0,0,-3.7],"direction":[0,0,1]},)"
                             R"("shape":{"type":"sphere","center":[0,0,0],"radius":1}})");
  const std::string text = explain_text(report_of(one, "sphere/centred"));
  EXPECT_TRUE(says(text, "Inputs\n   name  float32  stored value\n")) << text;
  EXPECT_TRUE(says(text, "-3.700000047683716")) << text;
}

TEST(TrueSentences, AnAnswerHasTheNameThatTheStepsGiveIt) {
  const Case one = read_case(R"({"ray":{"origin":[-3,0.1,0.2],"direction":[1,0,0]},)"
                             R"("shape":{"type":"box","min":[-1,-1,-1],"max":[1,1,1]}})");
  const std::string text = explain_text(report_of(one, "box/slabs"));
  for (const char* const who : {"exact      ", "box/slabs  "})
    EXPECT_TRUE(says(text, std::string(who) + std::string(15, ' ') + "hit: t_entry = 2, t_exit = 4\n"))
        << text;
  EXPECT_TRUE(says(text, "t_exit is the exact one")) << text;
}

TEST(TrueSentences, AStepThatLosesNothingOfNoteSaysNothingOfDigits) {
  for (const Lesson& lesson : lessons()) {
    const Stage stage = stage_of(lesson, report_lesson);
    for (const StageStep& step : stage.steps) {
      for (const std::string& words : {step.caption, step.digits, stage.conclusion}) {
        for (const char* untrue :
             {"No digits", "No more digits", "few ulps.", "They part", "not part", "there is."})
          EXPECT_FALSE(says(words, untrue)) << lesson.name << ": " << words;
      }
    }
  }
}

TEST(TrueSentences, DotsBearTheNameOfTheirFormat) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Case one = read_case(lessons_of("sphere").front()->case_text);
    one.precision = precision;
    const std::string caption = stage_of(report_of(one, "sphere/centred")).steps.back().caption;
    const char* const format = name_of(precision);
    EXPECT_TRUE(says(caption, std::string("Each dot is a ") + format + " value.")) << caption;
  }
}

}  // namespace
}  // namespace rayproof::viz
