#include <gtest/gtest.h>

#include <set>

#include "oracle/oracle.hpp"
#include "subjects/default_contract.hpp"
#include "unit/diagnosis/clinic.hpp"
#include "unit/diagnosis/faulty/faulty.hpp"
#include "unit/diagnosis/faulty/foreseen_flat.hpp"
#include "unit/diagnosis/faulty/foreseen_solids.hpp"

namespace rayproof::faulty {
namespace {

Answer foreseen(const Hypothesis& model, const Case& one) {
  const Answer exact = oracle::answer(one);
  const std::vector<Answer> answers = model.predict(one, exact);
  return answers.empty() ? exact : answers.front();
}

/// What is wrong of the verdicts and numbers of such a subject.
Patient patient_with(const Hypothesis& model) {
  Patient patient;
  patient.ask = [&model](std::span<const Case> cases) {
    std::vector<std::optional<Answer>> answers;
    for (const Case& one : cases) answers.emplace_back(foreseen(model, one));
    return answers;
  };
  patient.rule = [](const Case& one, const Answer& answer) {
    const oracle::Judgement judgement = oracle::judge(one, answer);
    return judgement.wrong || judgement.residual > 64 * judgement.far ? Ruling::broken : Ruling::held;
  };
  return patient;
}

class Model : public testing::TestWithParam<Foreseen> {};

TEST_P(Model, IsNamedWhereASubjectAnswersAsItForesees) {
  const Hypothesis* model = find_hypothesis(GetParam().model);
  ASSERT_NE(model, nullptr);
  const Patient patient = patient_with(*model);
  Subject guest;
  guest.contract = default_contract(GetParam().topic);
  std::vector<Case> failing, passing;
  for (unsigned k = 0; k < 60; ++k)
    for (const Family& family : families()) {
      if (family.topic != GetParam().topic || family.is_beyond_the_digits || failing.size() >= 64) continue;
      const Case one = family.generate(k, Precision::float64);
      if (!is_for_guest(guest, one)) continue;
      const bool is_wrong = patient.rule(one, foreseen(*model, one)) == Ruling::broken;
      if (is_wrong || passing.size() < 128) (is_wrong ? failing : passing).push_back(one);
    }
  ASSERT_FALSE(failing.empty());
  const auto groups = diagnose(patient, failing, passing);
  EXPECT_TRUE(in_words(groups).starts_with(std::string(model->name) + " ")) << in_words(groups);
}

/// What that model foresees of the case.
std::vector<Answer> foreseen_by(std::string_view model, const Case& one) {
  return find_hypothesis(model)->predict(one, oracle::answer(one));
}

// For a day that sources of one library were compiled together a function of another file was called here.
TEST(ModelOfNumbersOfAShape, SaysNothingOfAnEquation) {
  const Case one{.precision = Precision::float64, .question = Quadratic<double>{1e-46, 1e-50, 0}};
  EXPECT_TRUE(foreseen_by("shape-in-float", one).empty());
  EXPECT_TRUE(foreseen_by("whole-shape", one).empty());
}

TEST(ModelOfNumbersInFloats, SaysThatWhatIsTooLargeForThemMayBeMissed) {
  const auto triangle = [](double size) {
    return Case{
        .precision = Precision::float64,
        .question = RayQuestion{.ray = {{0, 0, -size}, {1, 1, 1}, 0, infinity<double>},
                                .shape = Triangle<double>{{0, 0, 0}, {0, 16 * size, 0}, {16 * size, 0, 0}}}};
  };
  ASSERT_EQ(foreseen_by("shape-in-float", triangle(1e40)).size(), 2U);
  EXPECT_EQ(std::get<RayAnswer>(foreseen_by("shape-in-float", triangle(1e40))[0]).hits.count, 0U);
  EXPECT_EQ(foreseen_by("shape-in-float", triangle(1e30)).size(), 1U);
}

TEST(ModelOfThePlaneThroughTheMean, MovesThePointOfAPolygonThatIsNotFlat) {
  const auto polygon = [](double lift) {
    return Case{.precision = Precision::float64,
                .question = RayQuestion{
                    .ray = {{0.25, 0.25, -2}, {0, 0, 1}, 0, infinity<double>},
                    .shape = Polygon<double>{{{0, 0, lift}, {1, 0, 0}, {1, 1, lift}, {0, 1, 0}}}}};
  };
  const auto z_of_point = [&](double lift) {
    return std::get<RayAnswer>(foreseen_by("point-on-plane-through-mean", polygon(lift)).at(0)).point->z;
  };
  EXPECT_EQ(z_of_point(0), 0);
  EXPECT_EQ(z_of_point(0.5), 0.25);
}

TEST(ModelOfAMovedPoint, SaysNothingOfABoundaryThatThePointStaysOn) {
  const auto at = [](double x) {
    return Case{.precision = Precision::float64,
                .question = PointAndPolygon<double>{{x, 0}, {{9, 0}, {0, 1}, {0, 0}}}};
  };
  for (const char* model : {"shape-in-float", "grid-10"}) {
    EXPECT_TRUE(foreseen_by(model, at(1)).empty()) << model;
    EXPECT_EQ(foreseen_by(model, at(-1)).size(), 1U) << model;
    EXPECT_EQ(foreseen_by(model, at(-1e-60)).size(), 3U) << model << ": it is moved to the boundary";
  }
}

TEST(ModelOfASignOfTheRadius, SaysNothingOfASphereWithoutOne) {
  const auto of_radius = [](double radius) {
    return Case{.precision = Precision::float64,
                .question = RayQuestion{.ray = {{0, 0, -2}, {0, 0, 1}, 0, 9},
                                        .shape = Sphere<double>{{0, 0, 0}, radius}}};
  };
  EXPECT_TRUE(foreseen_by("radius-square-added", of_radius(0)).empty());
  EXPECT_EQ(foreseen_by("radius-square-added", of_radius(1)).size(), 1U);
}

TEST(ModelOfIntegersOf32Bits, ReadsWholeNumbersAloneSo) {
  const auto at = [](double x) {
    return Case{.precision = Precision::float64,
                .question = RayQuestion{.ray = {{0, 0, x}, {0, 0, -0.5 * x}, 0, infinity<double>},
                                        .shape = Sphere<double>{{0, 0, 0}, 1}}};
  };
  EXPECT_TRUE(foreseen_by("whole-numbers-in-32-bits", at(2147483647)).empty());
  EXPECT_TRUE(foreseen_by("whole-numbers-in-32-bits", at(1e30)).empty()) << "it has an exponent";
  EXPECT_TRUE(foreseen_by("whole-numbers-in-32-bits", at(4294967296.5)).empty());
  const std::vector<Answer> found = foreseen_by("whole-numbers-in-32-bits", at(4294967298));
  ASSERT_EQ(found.size(), 3U);
  // 4294967298 wraps to 2, and -2147483649 to 2147483647.
  EXPECT_EQ(std::get<RayAnswer>(found[0]).hits.count, 0U);
  EXPECT_EQ(std::get<RayAnswer>(found[1]).hits.count, 2U);
}

TEST(ModelOfAFarCentre, DiffersFromALimitOfTWhereTheDirectionIsLong) {
  const Case far{.precision = Precision::float64,
                 .question = RayQuestion{.ray = {{0, 0, -30000}, {0, 0, 10}, 0, infinity<double>},
                                         .shape = Sphere<double>{{0, 0, 0}, 1}}};
  EXPECT_EQ(foreseen_by("far-centre-1e4", far).size(), 1U);
  EXPECT_TRUE(foreseen_by("far-centre-1e5", far).empty());
  const Answer exact = oracle::answer(far);
  EXPECT_TRUE(find_hypothesis("far-centre-1e4")->shows_more(far, exact));
  EXPECT_FALSE(find_hypothesis("far-centre-1e3")->shows_more(far, exact));
}

// Their places distinguish the mistakes.
TEST(ModelOfManyMistakes, ForeseesOneAnswerOfEach) {
  for (const Hypothesis& model : hypotheses()) {
    if (!model.is_one_of_many) continue;
    for (const std::string& topic : topics()) {
      std::set<std::size_t> counts;
      for (const Family& family : families())
        for (unsigned k = 0; k < 6 && family.topic == topic; ++k)
          counts.insert(foreseen_by(model.name, family.generate(k, Precision::float64)).size());
      counts.erase(0);
      EXPECT_LE(counts.size(), 1U) << model.name << " " << topic << ": " << testing::PrintToString(counts);
    }
  }
}

std::string name_of_model(const testing::TestParamInfo<Foreseen>& info) {
  std::string name = std::string(info.param.topic) + "_" + info.param.model;
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Diagnosis, Model, testing::ValuesIn(foreseen_faults), name_of_model);
INSTANTIATE_TEST_SUITE_P(DiagnosisOfSolids, Model, testing::ValuesIn(foreseen_faults_of_solids),
                         name_of_model);
INSTANTIATE_TEST_SUITE_P(DiagnosisOfFlat, Model, testing::ValuesIn(foreseen_faults_of_flat), name_of_model);

/// The model whose fault the subject has.
const Hypothesis* planted = nullptr;

TEST(Diagnosis, NamesWhatIsWronglySaidOfTheFirstHit) {
  struct WrongDetail {
    const char* topic;
    const char* property;
    const char* model;
  };
  for (const auto& [topic, property, model] : {WrongDetail{"cylinder", "normal", "normal-keeps-z"},
                                               {"cylinder", "normal", "normal-by-radii"},
                                               {"box", "normal", "normal-moved"},
                                               {"cylinder", "normal", "cap-normals-inward"},
                                               {"cylinder", "normal", "side-normal-faces-ray"},
                                               {"sphere", "normal", "normal-is-direction"},
                                               {"parallelepiped", "normal", "normal-along-edge"},
                                               {"parallelepiped", "normal", "normals-0-2"},
                                               {"sphere", "point", "point-against-direction"},
                                               {"sphere", "point", "point-from-shape"},
                                               {"sphere", "point", "point-at-radius-one"},
                                               {"sphere", "point", "point-at-radius"},
                                               {"triangle", "coordinates", "weights-decimals-2"},
                                               {"box", "normal", "normal-of-other-hit"},
                                               {"sphere", "point", "point-without-translation"},
                                               {"box", "point", "point-at-direction"},
                                               {"box", "normal", "normal-of-entry-axis"},
                                               {"box", "normal", "normal-of-farthest-axis"},
                                               {"parallelepiped", "normal", "normal-flipped-by-edges"},
                                               {"triangle", "coordinates", "given-undivided"},
                                               {"box", "normal", "normal-from-middle"},
                                               {"box", "normal", "normal-without-signs"},
                                               {"box", "point", "point-by-unit-direction"},
                                               {"box", "normal", "normal-of-near-hit"},
                                               {"triangle", "normal", "normal-flipped-by-mirror"},
                                               {"sphere", "normal", "normal-by-columns"},
                                               {"sphere", "normal", "normal-of-far-hit"},
                                               {"triangle", "point", "point-by-other-weights"},
                                               {"polygon", "normal", "normal-about-mean"},
                                               {"triangle", "touch", "vertex-called-edge"},
                                               {"triangle", "touch", "edge-called-vertex"},
                                               {"triangle", "touch", "crossing-called-edge"},
                                               {"triangle", "touch", "edge-called-near-1e-2"},
                                               {"sphere", "touch", "tangent-called-near-1e-2"},
                                               {"triangle", "coordinates", "weights-exchanged-along-axis"}}) {
    planted = find_hypothesis(model);
    const Subject subject = subject_of(topic, [](const Case& one) { return foreseen(*planted, one); });
    const auto groups = faults_of(subject, *find_property(property), Precision::float64, 60);
    EXPECT_TRUE(in_words(groups).starts_with(std::string(model) + " ")) << in_words(groups);
  }
}

}  // namespace
}  // namespace rayproof::faulty
