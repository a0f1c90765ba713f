#include "unit/viz/walkthrough/captions/lesson_caption.hpp"
#include "viz/explain/case_report.hpp"
#include "viz/programs/report_of.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

std::string behind(const std::string& sentence, const std::string& mark) {
  return sentence.substr(sentence.find(mark) + mark.size());
}

void expect_verdict(const LessonSaid& s, const std::string& method) {
  const CaseReport report = report_of(s.stage.one, method);
  EXPECT_EQ(behind(s.sentence, ": "), verdict_of(method.empty() ? &report.exact : report.claim()) + ".");
}

void expect_answer(const LessonSaid& s, const std::string& method) {
  EXPECT_EQ(behind(s.sentence, ": "), answer_in_words(report_of(s.stage.one, method)) + ".");
}

/// Of all values of the stage the named one has lost most.
void expect_worst(const LessonSaid& s) {
  double most = 0, named = 0;
  for (const StageStep& step : s.stage.steps) {
    for (const StageValue& value : step.values) {
      const double lost = worst_component(value).bits_lost;
      most = std::max(most, lost);
      if (s.sentence.starts_with("Of all values " + value.name + " lost")) named = std::max(named, lost);
    }
  }
  EXPECT_EQ(named, most);
}

}  // namespace

/// Of the first step and the last, which every stage has.
std::vector<LessonClaim> comparison_claims() {
  return {
      {"", "What is given: *"},
      // true_sentences_test holds these to the answers, for random cases of every family.
      {"", "The computed * is off by *: exact * (to 53 bits), computed * (float32)."},
      {"", "The computed * is the exact one, correctly rounded: exact * (to 53 bits), computed * (float32)."},
      {"", "Each dot is a float32 value."},
      {"", "Float result and exact result are the same: *."},
      {"", "Of all values * lost the most, * of 24 bits: exact *, computed *.", expect_worst},
      {"", "Float result and exact result differ.",
       [](const LessonSaid& s) {
         const CaseReport report = report_of(s.stage.one, s.stage.method);
         EXPECT_TRUE(verdicts_differ(&report.exact, report.claim()));
       }},
      {"", "Exact: *.", [](const LessonSaid& s) { expect_verdict(s, ""); }},
      {"", "Computed: *.", [](const LessonSaid& s) { expect_verdict(s, s.stage.method); }},
      {"", "*/* says: *.",
       [](const LessonSaid& s) { expect_answer(s, s.sentence.substr(0, s.sentence.find(' '))); }},
      {"", "So the verdict is: *."},
      // It names the space whose items the step shows.
      {"", "Drawn in the *.", [](const LessonSaid& s) { EXPECT_TRUE(s.stage.steps[s.step].is_apart); }}};
}

}  // namespace rayproof::viz
