#include <gtest/gtest.h>

#include "oracle/oracle.hpp"
#include "properties/diagnosis/examination/sizes_of_mistakes.hpp"
#include "subjects/default_contract.hpp"
#include "unit/diagnosis/clinic.hpp"

namespace rayproof::faulty {
namespace {

/// A subject that is right, but answers as `changed(case, exact answer)`.
template <class Changed>
Patient patient_who(Changed changed) {
  Patient patient;
  patient.ask = [changed](std::span<const Case> cases) {
    std::vector<std::optional<Answer>> answers;
    for (const Case& one : cases) answers.emplace_back(changed(one, oracle::answer(one)));
    return answers;
  };
  patient.rule = [](const Case& one, const Answer& answer) {
    const oracle::Judgement judgement = oracle::judge(one, answer);
    return judgement.wrong || judgement.residual > 64 * judgement.far ? Ruling::broken : Ruling::held;
  };
  return patient;
}

/// The largest group of what fails of that subject of a topic.
Diagnosis diagnosis_of(const Patient& patient, std::string_view topic) {
  Subject guest;
  guest.contract = default_contract(std::string(topic));
  std::vector<Case> failing, passing;
  for (unsigned k = 0; k < 60; ++k)
    for (const Family& family : families()) {
      if (family.topic != topic || family.is_beyond_the_digits || failing.size() >= 64) continue;
      const Case one = family.generate(k, Precision::float64);
      if (!is_for_guest(guest, one)) continue;
      const std::optional<Answer> answer = patient.ask({&one, 1}).front();
      const bool is_wrong = patient.rule(one, *answer) == Ruling::broken;
      if (is_wrong || passing.size() < 64) (is_wrong ? failing : passing).push_back(one);
    }
  return diagnose(patient, failing, passing).front();
}

TEST(MeasuredMistake, IsAFactorOfTheRadiusWhateverItsSize) {
  const Patient patient = patient_who([](const Case& one, const Answer& exact) {
    Case larger = one;
    auto* asked = std::get_if<RayQuestion>(&larger.question);
    if (asked == nullptr) return exact;
    std::get<Sphere<double>>(asked->shape).radius *= 1.003;
    return oracle::answer(larger);
  });
  const Diagnosis found = diagnosis_of(patient, "sphere");
  ASSERT_NE(found.cause, nullptr);
  EXPECT_EQ(found.cause->name, "radius-times");
  EXPECT_TRUE(found.sentence.ends_with(", about 1.003")) << found.sentence;
}

TEST(MeasuredMistake, IsAFactorOfTheSecondNumberAlone) {
  const Patient patient = patient_who([](const Case&, Answer exact) {
    auto& roots = std::get<QuadraticAnswer<double>>(exact);
    if (roots.count == 2) roots.roots[1] *= 1.01;
    return exact;
  });
  const Diagnosis found = diagnosis_of(patient, "quadratic");
  ASSERT_NE(found.cause, nullptr);
  EXPECT_EQ(found.cause->name, "second-times");
}

TEST(SizeOfAMistake, IsAlikeToAFewPercent) {
  for (const double size : {1e-300, 3e-7, 1.0, 1e200}) {
    const std::size_t number = diagnosis::number_of_size(size);
    EXPECT_TRUE(diagnosis::is_of_size(1.01 * size, number));
    EXPECT_FALSE(diagnosis::is_of_size(1.1 * size, number));
    EXPECT_FALSE(diagnosis::is_of_size(-size, number));
    EXPECT_NEAR(diagnosis::size_of_number(number) / size, 1, 0.01);
  }
  EXPECT_FALSE(diagnosis::is_of_size(0, diagnosis::number_of_size(0))) << "no mistake is none";
}

TEST(SizesOfMistakes, HaveTheMeanOfThoseThatAreMostlyAlike) {
  EXPECT_NEAR(diagnosis::mean_of_usual({7, 1.0, 1.01, 0.99, -1}), 1, 1e-9);
  EXPECT_EQ(diagnosis::mean_of_usual({}), 0);
}

}  // namespace
}  // namespace rayproof::faulty
