#include <gtest/gtest.h>

#include "oracle/oracle.hpp"
#include "subjects/default_contract.hpp"
#include "unit/diagnosis/clinic.hpp"
#include "unit/diagnosis/faulty/faulty.hpp"

namespace rayproof::faulty {
namespace {

/// A subject that has the fault of a model: it gives the answer that the model foresees.
struct Foreseen {
  const char* topic;
  const char* model;
};
void PrintTo(const Foreseen& one, std::ostream* out) { *out << one.topic << ": " << one.model; }

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
      if (family.topic != GetParam().topic || failing.size() >= 64) continue;
      const Case one = family.generate(k, Precision::float64);
      if (!is_for_guest(guest, one)) continue;
      const bool is_wrong = patient.rule(one, foreseen(*model, one)) == Ruling::broken;
      if (is_wrong || passing.size() < 64) (is_wrong ? failing : passing).push_back(one);
    }
  ASSERT_FALSE(failing.empty());
  const auto groups = diagnose(patient, failing, passing);
  EXPECT_TRUE(in_words(groups).starts_with(std::string(model->name) + " ")) << in_words(groups);
}

const Foreseen foreseen_faults[] = {
    {"sphere", "zero-as-no-end"},
    {"sphere", "origin-ignored"},
    {"sphere", "origin-negated"},
    {"sphere", "direction-as-target"},
    {"sphere", "points-y-z"},
    {"box", "points-x-z"},
    {"plane", "vectors-x-y"},
    {"triangle", "origin-x-z"},
    {"sphere", "direction-y-z"},
    {"point_in_polygon", "point-x-y"},
    {"sphere", "whole-points"},
    {"sphere", "whole-origin"},
    {"sphere", "discriminant-of-sphere"},
    {"sphere", "nearest-point"},
    {"sphere", "half-chord"},
    {"box", "direction-as-origin"},
    {"triangle", "triangle-constant-negated"},
    {"sphere", "negated"},
    {"plane", "absolute"},
    {"plane", "times-slope"},
    {"sphere", "origin-not-transformed"},
    {"sphere", "interval-as-object-distances"},
    {"box", "small-determinant-1e-4"},
    {"sphere", "point-missed"},
    {"plane", "behind-at-t-min"},
    {"box", "flat-box-missed"},
    {"box", "max-as-size"},
    {"parallelepiped", "parallelepiped-as-bounds"},
    {"parallelepiped", "edges-times-length"},
    {"parallelepiped", "edges-as-orthogonal"},
    {"parallelepiped", "corner-as-centre"},
    {"cylinder", "caps-missing"},
    {"cylinder", "upper-cap-missing"},
    {"cylinder", "upper-end-not-tested"},
    {"cylinder", "lower-end-not-tested"},
    {"cylinder", "first-side-hit-decides"},
    {"cylinder", "cylinder-as-box"},
    {"triangle", "edges-loose-1e-2"},
    {"triangle", "triangle-bounds"},
    {"triangle", "edge-b-open"},
    {"polygon", "first-corner-culls"},
    {"polygon", "fan"},
    {"sphere", "nearest-twice"},
    {"sphere", "farthest-twice"},
    {"box", "missed-in-face"},
    {"box", "farthest-twice"},
    {"quadratic", "discriminant-without-four"},
    {"quadratic", "linear-root-negated"},
    {"polygon", "collinear-corner"},
    {"polygon", "last-side-missing-against"},
    {"polygon", "last-side-missing-in-order"},
    {"point_in_polygon", "last-side-missing-upward"},
    {"polygon", "normal-z-sign"},
    {"polygon", "inequality-unturned"},
    {"plane", "normal-y-sign"},
    {"plane", "sign-of-slope"},
    {"plane", "minus-sign-of-slope"},
    {"triangle", "edge-c-from-b"},
    {"triangle", "edge-b-from-c"},
    {"sphere", "points-y-for-z"},
    {"box", "direction-x-for-z"},
    {"cylinder", "origin-x-for-y"},
    {"parallelepiped", "place-ignored"},
    {"box", "place-ignored"},
    {"sphere", "centre-behind-missed"},
    {"box", "slab-along-not-tested"},
    {"parallelepiped", "missed-along-slab"},
    {"parallelepiped", "endless-edge-2"},
    {"cylinder", "missed-along-axis"},
    {"cylinder", "radii-rooted"},
    {"point_in_polygon", "inequality-unturned"},
    {"point_in_polygon", "never-inside"},
    {"polygon", "endless-sides"},
    {"point_in_polygon", "endless-sides"},
    {"point_in_polygon", "both-ways"},
    {"parallelepiped", "half-endless-edge-1"},
    {"point_in_polygon", "inside-out"},
    {"point_in_polygon", "whole-point"},
    {"point_in_polygon", "grid-16"},
    {"plane", "rounded-down"},
    {"quadratic", "rounded-down"},
    {"quadratic", "cut-off"},
    {"quadratic", "root-alone"},
    {"sphere", "near-hit-behind"},
    {"box", "leaves-at-last-end"},
    {"parallelepiped", "enters-at-first-beginning"},
    {"parallelepiped", "corner-faces-alone"},
    {"cylinder", "caps-of-radius-rx"},
    {"cylinder", "caps-of-rooted-radius"},
    {"cylinder", "caps-from-outside-alone"},
    {"cylinder", "radii-doubled"},
    {"cylinder", "radii-mean"},
    {"cylinder", "height-halved"},
    {"cylinder", "axis-is-y"},
    {"cylinder", "axis-turned-to-x"},
    {"polygon", "first-four-vertices"},
    {"point_in_polygon", "first-four-vertices"},
    {"point_in_polygon", "upright-sides"},
    {"plane", "distance-to-plane"},
    {"parallelepiped", "edges-transposed"},
    {"quadratic", "positive-roots-alone"},
    {"quadratic", "real-part"},
    {"point_in_polygon", "endless-boundary"},
    {"cylinder", "origin-z-ignored"},
    {"sphere", "far-hit-beyond"},
    {"sphere", "behind-origin-missed"},
    {"plane", "missed-from-back"},
    {"triangle", "missed-from-front"},
    {"box", "transpose-as-inverse"},
    {"sphere", "uniform-scale"},
    {"box", "bounds-in-world"},
    {"box", "two-corners-in-world"},
    {"triangle", "bounding-sphere-too-small"},
    {"sphere", "single-hit-twice"},
    {"triangle", "single-hit-twice"},
    {"parallelepiped", "corner-not-moved"},
    {"parallelepiped", "edges-translated"},
    {"parallelepiped", "leaves-before-it-enters"},
    {"cylinder", "radii-one"},
    {"cylinder", "height-one"},
    {"quadratic", "times-a-squared"},
    {"point_in_polygon", "repeated-vertices"},
    {"box", "missed-in-high-face"},
    {"parallelepiped", "missed-in-low-face"},
    {"sphere", "nearer-to-zero-decides"},
    {"parallelepiped", "faces-as-rectangles"},
    {"triangle", "edges-loose-1e-5"},
    {"plane", "epsilon-1e-12"},
    {"sphere", "type-epsilon"},
    {"point_in_polygon", "sides-loose-1e-3"},
    {"polygon", "sides-loose-1e-4"},
    {"sphere", "discriminant-with-four"},
    {"quadratic", "discriminant-with-four"},
    {"cylinder", "discriminant-without-four"},
    {"quadratic", "discriminant-with-two"},
    {"quadratic", "discriminant-plus"},
    {"quadratic", "whole-b-for-half"},
    {"sphere", "half-b-for-whole"},
    {"quadratic", "discriminant-unrooted"},
    {"quadratic", "root-alone-divided"},
    {"sphere", "b-alone-divided"},
    {"quadratic", "undivided"},
    {"quadratic", "b-not-halved"},
    {"sphere", "root-not-halved"},
    {"quadratic", "double-root-halved"},
    {"quadratic", "double-root-doubled"},
    {"quadratic", "double-root-negated"},
    {"quadratic", "double-root-undivided"},
    {"quadratic", "linear-root-inverted"},
    {"sphere", "term-of-d-d-x"},
    {"sphere", "term-of-l-d-y"},
    {"sphere", "term-of-l-l-z"},
    {"plane", "term-of-n-d-z"},
    {"plane", "term-of-n-o-x"},
    {"plane", "reciprocal"},
    {"box", "t-max-as-distance"},
    {"box", "slabs-unsorted"},
    {"box", "slab-exchanged-y"},
    {"box", "slab-unsorted-z"},
    {"box", "solid-wider-1e-3"},
    {"parallelepiped", "solid-wider-1e-4"},
    {"cylinder", "side-missed-along-1e-3"},
    {"triangle", "weights-undivided"},
    {"triangle", "beta-undivided"},
    {"triangle", "gamma-undivided"},
    {"triangle", "weights-times-area"},
    {"triangle", "factors-exchanged"},
    {"triangle", "tested-along-normal"},
    {"triangle", "edge-c-turned"},
    {"triangle", "cross-product-x"},
    {"plane", "cross-product-y"},
    {"polygon", "tested-against-direction"},
    {"triangle", "tested-without-origin"},
    {"triangle", "tested-by-unit-direction"},
    {"parallelepiped", "faces-undivided"},
    {"parallelepiped", "face-u-undivided"},
    {"parallelepiped", "faces-of-unit-edges"},
    {"parallelepiped", "faces-by-unit-projections"},
    {"parallelepiped", "faces-as-triangles"},
    {"parallelepiped", "coordinates-undivided"},
    {"parallelepiped", "over-volume"},
    {"parallelepiped", "times-volume"},
    {"parallelepiped", "edges-doubled"},
    {"parallelepiped", "edges-both-ways"},
    {"point_in_polygon", "compares-first-vertex"},
    {"point_in_polygon", "compares-second-vertex"},
    {"polygon", "compares-farther-vertex"},
    {"box", "solid-narrower-1e-2"},
    {"cylinder", "solid-narrower-1e-3"},
    {"quadratic", "discriminant-small-1e-5"},
    {"sphere", "discriminant-small-1e-4"},
    {"cylinder", "discriminant-small-1e-2"},
    {"sphere", "discriminant-negative-1e-3"},
    {"quadratic", "a-as-one"},
    {"quadratic", "b-negated"},
    {"quadratic", "c-negated"},
    {"quadratic", "a-c-exchanged"},
    {"quadratic", "b-of-one-root-negated"},
    {"quadratic", "rounded-to-whole"},
    {"quadratic", "absolute"},
    {"sphere", "radius-square-added"},
    {"sphere", "last-hit-alone"},
    {"sphere", "positive-t-alone"},
    {"box", "size-as-half"},
    {"box", "sum-as-middle"},
    {"box", "slabs-without-signs"},
    {"cylinder", "smaller-side-root"},
    {"cylinder", "larger-side-root"},
    {"cylinder", "first-side-root"},
    {"cylinder", "side-without-ends"},
    {"cylinder", "endless-cylinder"},
    {"cylinder", "caps-where-side-missed"},
    {"point_in_polygon", "crossing-wrong"},
    {"polygon", "crossing-wrong-in-order"},
    {"point_in_polygon", "crossing-wrong-upward"},
    {"point_in_polygon", "any-crossing"},
    {"point_in_polygon", "one-way-sides"},
    {"point_in_polygon", "bounds-but-first"},
    {"point_in_polygon", "endless-upright-boundary"},
    {"point_in_polygon", "side-not-on-boundary"},
    {"point_in_polygon", "shape-in-float"},
    {"parallelepiped", "edges-halved"},
    {"parallelepiped", "corner-negated"},
    {"parallelepiped", "edge-1-negated"},
};

std::string name_of_model(const testing::TestParamInfo<Foreseen>& info) {
  std::string name = std::string(info.param.topic) + "_" + info.param.model;
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Diagnosis, Model, testing::ValuesIn(foreseen_faults), name_of_model);

/// Subjects with the fault of a model of what is said of the first hit.
struct ForeseenDetail {
  const char* topic;
  const char* property;
  const char* model;
  Answer (*code)(const Case&);
};

TEST(Diagnosis, NamesWhatIsWronglySaidOfTheFirstHit) {
  for (const auto& [topic, property, model, code] : std::initializer_list<ForeseenDetail>{
           {"cylinder", "normal", "normal-keeps-z",
            [](const Case& one) { return foreseen(*find_hypothesis("normal-keeps-z"), one); }},
           {"cylinder", "normal", "cap-normals-inward",
            [](const Case& one) { return foreseen(*find_hypothesis("cap-normals-inward"), one); }},
           {"cylinder", "normal", "side-normal-faces-ray",
            [](const Case& one) { return foreseen(*find_hypothesis("side-normal-faces-ray"), one); }},
           {"sphere", "normal", "normal-is-direction",
            [](const Case& one) { return foreseen(*find_hypothesis("normal-is-direction"), one); }},
           {"parallelepiped", "normal", "normal-along-edge",
            [](const Case& one) { return foreseen(*find_hypothesis("normal-along-edge"), one); }},
           {"sphere", "point", "point-against-direction",
            [](const Case& one) { return foreseen(*find_hypothesis("point-against-direction"), one); }},
           {"sphere", "point", "point-from-shape",
            [](const Case& one) { return foreseen(*find_hypothesis("point-from-shape"), one); }},
           {"box", "normal", "normal-from-middle",
            [](const Case& one) { return foreseen(*find_hypothesis("normal-from-middle"), one); }},
           {"box", "normal", "normal-without-signs",
            [](const Case& one) { return foreseen(*find_hypothesis("normal-without-signs"), one); }},
           {"triangle", "point", "point-by-other-weights",
            [](const Case& one) { return foreseen(*find_hypothesis("point-by-other-weights"), one); }}}) {
    const auto groups = faults_of(subject_of(topic, code), *find_property(property), Precision::float64, 60);
    EXPECT_TRUE(in_words(groups).starts_with(std::string(model) + " ")) << in_words(groups);
  }
}

}  // namespace
}  // namespace rayproof::faulty
