/// \file
/// What a step's sentences claim (at right angles, signs, orders, equal, inside, lost) holds of the exact
/// numbers of hundreds of random cases a topic.

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "properties/numbers.hpp"
#include "properties/trial.hpp"
#include "unit/viz/walkthrough/captions/caption.hpp"
#include "viz/programs/report_of.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

/// Every method that can be recorded, on random cases of every family.
void for_recorded_cases(std::uint64_t seeds, const std::function<void(const CaseReport&)>& check) {
  for (const Family& family : families()) {
    for (const Subject& subject : subjects()) {
      if (subject.topic != family.topic) continue;
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        for (const Precision precision : {Precision::float32, Precision::float64}) {
          const CaseReport report = report_of(family.generate(1000 + seed, precision), &subject);
          if (!report.walk) break;
          check(report);
        }
      }
    }
  }
}

/// Products of three of the case's numbers are normal numbers of its precision, and its map leaves a ray most
/// of its digits.
bool is_tame(Case one) {
  const double most = one.precision == Precision::float32 ? 1e12 : 1e60;
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  if (asked != nullptr && asked->transform && condition_of(*asked->transform) > std::pow(most, 0.25))
    return false;
  return std::ranges::all_of(numbers_of(one), [&](const CaseNumber& number) {
    const double size = std::abs(*number.value);
    return size == 0 || std::isinf(size) || (size > 1 / most && size < most);
  });
}

TEST(KernelCaptions, EverySentenceIsKnownAndTrueOfTheExactNumbers) {
  const std::vector<CheckedClaim> claims = kernel_claims();
  std::map<std::string, std::size_t> checked;
  std::set<std::string> unknown;
  for_recorded_cases(6, [&](const CaseReport& report) {
    const bool is_checked = is_tame(report.one);
    for (std::size_t i = 0; i < report.walk->steps.size(); ++i) {
      const NumbersByName n(*report.walk, i);
      for (const std::string& sentence : sentences_of(report.walk->steps[i].meaning)) {
        const CheckedClaim* const claim = find_claim(claims, sentence);
        if (claim == nullptr) {
          unknown.insert(report.method + ": " + sentence);
          continue;
        }
        if (!is_checked) continue;
        ++checked[claim->words];
        if (claim->check == nullptr) continue;
        SCOPED_TRACE(report.method + ": " + sentence + "\n" + write_case(report.one));
        claim->check({report, n});
      }
    }
  });
  for (const std::string& sentence : unknown)
    ADD_FAILURE() << sentence << "\nis no sentence that a check of unit/viz/walkthrough/captions knows";
  for (const CheckedClaim& claim : claims) EXPECT_GT(checked[claim.words], 50U) << claim.words;
}

TEST(KernelCaptions, PatternsFitNumbersAndNothingElse) {
  EXPECT_TRUE(fits("z = # and z = #.", "z = 0 and z = -1.5e-7."));
  EXPECT_TRUE(fits("n = # is", "n = (0, -∞, NaN) is"));
  EXPECT_TRUE(fits("*: hit", "Exact: hit"));
  EXPECT_FALSE(fits("z = #.", "z = a."));
  EXPECT_FALSE(fits("z = 0.", "z = 0. And more."));
  EXPECT_EQ(find_claim(kernel_claims(), "A sentence that nobody has entered."), nullptr);
}

}  // namespace
}  // namespace rayproof::viz
