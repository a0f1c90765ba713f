#include <gtest/gtest.h>

#include <set>

#include "properties/claims/answers.hpp"
#include "subjects/default_contract.hpp"
#include "unit/diagnosis/clinic.hpp"
#include "unit/diagnosis/faulty/planted.hpp"

namespace rayproof::faulty {
namespace {

using enum Fault;

class PlantedFault : public testing::TestWithParam<Planted> {};

TEST_P(PlantedFault, IsNamed) {
  const Planted& one = GetParam();
  const Subject subject = subject_of(one.topic, one.code);
  const std::string found = in_words(faults_of(subject, *find_property(one.property), one.precision));
  EXPECT_TRUE(found.starts_with(std::string(one.cause) + " ")) << "found: " << found;
}

std::string name_of_test(const testing::TestParamInfo<Planted>& info) {
  std::string name = std::to_string(info.index) + "_" + info.param.topic + "_" + info.param.property + "_" +
                     info.param.cause;
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Diagnosis, PlantedFault, testing::ValuesIn(planted), name_of_test);

/// What a cure helps is as bad as its cases are (kind.hpp); what a model foresees is a fault of its own.
TEST(Diagnosis, ForeseesNoWrongAnswersOfRightCode) {
  for (const std::string& topic : topics()) {
    const Subject right = subject_of(topic.c_str(), answer<nothing>);
    for (const char* const property : {"verdict", "residual", "ascending"})
      for (const Precision precision : {Precision::float32, Precision::float64})
        for (const Diagnosis& group : faults_of(right, *find_property(property), precision, 60))
          EXPECT_TRUE(group.cause == nullptr || group.cause->change != nullptr)
              << topic << " " << property << ": " << group.sentence;
  }
}

TEST(Diagnosis, OfTwoFaultsUnderOnePropertyMakesTwoGroups) {
  const Subject subject = subject_of("triangle", two_faults);
  const auto groups = faults_of(subject, *find_property("verdict"), Precision::float64);
  std::set<std::string_view> causes;
  for (const Diagnosis& group : groups)
    if (group.cause != nullptr) causes.insert(group.cause->name);
  EXPECT_TRUE(causes.contains("culls-back-faces")) << in_words(groups);
  EXPECT_TRUE(causes.contains("edge-b-not-tested")) << in_words(groups);
}

/// The sphere stands twice as far from the origin of coordinates as it is said to.
Answer of_sphere_twice_as_far(const Case& one) {
  Case other = one;
  std::get<Sphere<double>>(std::get<RayQuestion>(other.question).shape).center *= 2;
  return oracle::answer(other);
}

TEST(Diagnosis, CallsNothingRoundingThatIsWrongerThanLostDigits) {
  const Subject subject = subject_of("sphere", of_sphere_twice_as_far);
  const auto groups = faults_of(subject, *find_property("residual"), Precision::float64);
  ASSERT_FALSE(groups.empty());
  EXPECT_TRUE(in_words(groups).starts_with("shape-at-zero ")) << in_words(groups);
  for (const Diagnosis& group : groups) EXPECT_NE(group.kind, FindingKind::rounding) << group.sentence;
}

/// Möller and Trumbore's, with a determinant that a float holds: GLM's intersectLineTriangle is so.
Answer with_determinant_in_float(const Case& one) {
  const auto& [ray, shape, transform] = std::get<RayQuestion>(one.question);
  if (transform) return oracle::answer(one);
  const auto& triangle = std::get<Triangle<double>>(shape);
  const glm::dvec3 b = triangle.b - triangle.a, c = triangle.c - triangle.a, from_a = ray.origin - triangle.a;
  const glm::dvec3 across = glm::cross(ray.direction, c), beside = glm::cross(from_a, b);
  const auto determinant = static_cast<float>(glm::dot(b, across));
  const double beta = glm::dot(from_a, across) / determinant,
               gamma = glm::dot(ray.direction, beside) / determinant;
  const double t = glm::dot(c, beside) / determinant;
  RayAnswer answer;
  if (!(beta >= 0 && gamma >= 0 && beta + gamma <= 1 && in_interval(ray, t))) return answer;
  answer.hits.push_back(t);
  answer.barycentric = glm::dvec3(1 - beta - gamma, beta, gamma);
  return answer;
}

TEST(Diagnosis, FindsAFloatOnTheWayThoughSmallNumbersShowNothingOfIt) {
  const Subject subject = subject_of("triangle", with_determinant_in_float);
  for (const auto& [property, cause] :
       {std::pair{"residual", "float-on-the-way "}, std::pair{"coordinates", "float-in-coordinates "}}) {
    const std::string found = in_words(faults_of(subject, *find_property(property), Precision::float64));
    EXPECT_TRUE(found.starts_with(cause)) << found;
  }
}

/// The nearest hit alone, up to half a percent too near, by no fixed factor.
Answer nearest_too_near(const Case& one) {
  Answer answer = oracle::answer(one);
  auto& hits = std::get<RayAnswer>(answer);
  hits.nearest_only = true;
  hits.point.reset();
  hits.hits.count = std::min<std::size_t>(hits.hits.count, 1);
  const double x = std::get<RayQuestion>(one.question).ray.origin.x;
  hits.hits.t[0] *= 1 - 0.005 * (0.2 + 0.8 * std::abs(std::sin(1e3 * x)));
  return answer;
}

TEST(Diagnosis, CallsTheNearestHitApproximateWhereTheFartherOneIsNotGiven) {
  const Subject subject = subject_of("sphere", nearest_too_near);
  const std::string found = in_words(faults_of(subject, *find_property("residual"), Precision::float32));
  EXPECT_TRUE(found.starts_with("approximate ")) << found;
}

/// The nearest hit alone, as sphere tracing finds it: it stops within 1e-3 before the surface.
Answer marched_to_the_surface(const Case& one) {
  Answer answer = nearest_too_near(one);
  const auto& ray = std::get<RayQuestion>(one.question).ray;
  const Answer exact = oracle::answer(one);
  auto& hits = std::get<RayAnswer>(answer).hits;
  const double left = 1e-3 * (0.1 + 0.8 * std::abs(std::sin(1e3 * ray.origin.x)));
  if (hits.count > 0) hits.t[0] = std::get<RayAnswer>(exact).hits.t[0] - left / glm::length(ray.direction);
  return answer;
}

TEST(Diagnosis, NamesTheLengthAtWhichAnIterationStops) {
  const Subject subject = subject_of("sphere", marched_to_the_surface);
  const std::string found = in_words(faults_of(subject, *find_property("residual"), Precision::float32));
  EXPECT_TRUE(found.starts_with("stops-at-1e-3 ")) << found;
}

/// Every t off by up to a thousandth, by chance.
Answer with_jitter(const Case& one) {
  static Random random(7);
  Answer answer = oracle::answer(one);
  auto& ray = std::get<RayAnswer>(answer);
  ray.point.reset();
  for (double& t : ray.hits.t) t *= 1 + 1e-3 * random.uniform(-1, 1);
  return answer;
}

TEST(Diagnosis, KnowsChanceByAskingTheSameCaseAgain) {
  const Subject subject = subject_of("sphere", with_jitter);
  const std::string found = in_words(faults_of(subject, *find_property("residual"), Precision::float32));
  EXPECT_TRUE(found.starts_with("asked-again ")) << found;
}

/// Where the ray runs along the plane t is that of the case before.
Answer with_t_left_from_before(const Case& one) {
  static double last = 1;
  auto answer = std::get<RayAnswer>(oracle::answer(one));
  if (answer.hits.count > 0) last = answer.hits.t[0];
  const bool is_along = answer.contact == Contact::parallel || answer.contact == Contact::in_surface;
  if (is_along && in_interval(std::get<RayQuestion>(one.question).ray, last)) answer.hits.push_back(last);
  return answer;
}

TEST(Diagnosis, SaysThatWhatIsGivenAlongAPlaneIsLeftFromTheCaseBefore) {
  const Subject subject = subject_of("plane", with_t_left_from_before);
  const auto groups = faults_of(subject, *find_property("residual"), Precision::float64);
  ASSERT_FALSE(groups.empty());
  EXPECT_TRUE(in_words(groups).starts_with("asked-again ")) << in_words(groups);
  EXPECT_TRUE(groups.front().sentence.ends_with("what was left from the case before"))
      << groups.front().sentence;
}

/// No t: what a program of verdicts says.
Answer verdict_alone(bool is_hit) {
  RayAnswer verdict{.verdict_only = true};
  if (is_hit) verdict.hits.push_back(std::numeric_limits<double>::quiet_NaN());
  return verdict;
}

/// The verdict alone, of a box that is larger by a tenth on every side.
Answer whether_a_larger_box_is_met(const Case& one) {
  Case larger = one;
  auto& box = std::get<Box<double>>(std::get<RayQuestion>(larger.question).shape);
  box.min -= 0.1;
  box.max += 0.1;
  return verdict_alone(std::get<RayAnswer>(oracle::answer(larger)).hits.count > 0);
}

TEST(Diagnosis, TakesAVerdictWithoutATForTheSameWhenAskedAgain) {
  const Subject subject = subject_of("box", whether_a_larger_box_is_met);
  const std::string found = in_words(faults_of(subject, *find_property("verdict"), Precision::float32));
  EXPECT_FALSE(found.empty());
  EXPECT_EQ(found.find("asked-again"), std::string::npos) << found;
}

Answer always_a_hit(const Case& /*any*/) { return verdict_alone(true); }

TEST(Diagnosis, NeverSaysOfVerdictsAloneThatANumberIsNaN) {
  const Subject subject = subject_of("triangle", always_a_hit);
  const std::string found = in_words(faults_of(subject, *find_property("verdict"), Precision::float32));
  EXPECT_FALSE(found.empty());
  EXPECT_EQ(found.find("is-nan"), std::string::npos) << found;
}

TEST(Diagnosis, AsksNoRayThatBeginsBeforeItsOriginWhereItStartsNearer) {
  const Case far{.question = RayQuestion{.ray = {{100, 0, 0}, {-1, 0, 0}, 0, infinity<double>},
                                         .shape = Sphere<double>{{0, 0, 0}, 0x1p-13}}};
  const std::vector<Case> near = find_hypothesis("start-near")->change(far);
  ASSERT_EQ(near.size(), 1U);
  const Ray<double>& ray = std::get<RayQuestion>(near.front().question).ray;
  EXPECT_EQ(ray.origin, glm::dvec3(1 + 0x1p-13, 0, 0));
  EXPECT_EQ(ray.t_min, 0);
}

/// Right, but for rays that start at the centre.
Answer missed_from_the_centre(const Case& one) {
  const auto& asked = std::get<RayQuestion>(one.question);
  const bool is_at_centre = asked.ray.origin == std::get<Sphere<double>>(asked.shape).center;
  return is_at_centre ? RayAnswer{} : oracle::answer(one);
}

TEST(Diagnosis, CallsNoMissOfAWholeShapeAMatterOfTheBoundary) {
  const Subject subject = subject_of("sphere", missed_from_the_centre);
  for (const Diagnosis& group : faults_of(subject, *find_property("verdict"), Precision::float64))
    EXPECT_EQ(group.kind, FindingKind::gross) << group.sentence;
}

/// The textbook's sphere, but for the discriminant, which a float holds.
Answer with_discriminant_in_float(const Case& one) {
  const auto& [ray, shape, transform] = std::get<RayQuestion>(one.question);
  if (transform) return oracle::answer(one);
  const auto& [center, radius] = std::get<Sphere<double>>(shape);
  const glm::dvec3 f = ray.origin - center;
  const double a = glm::dot(ray.direction, ray.direction), b = glm::dot(f, ray.direction);
  const double root = std::sqrt(double{static_cast<float>(b * b - a * (glm::dot(f, f) - radius * radius))});
  RayAnswer answer;
  for (const double t : {(-b - root) / a, (-b + root) / a})
    if (in_interval(ray, t)) answer.hits.push_back(t);
  return answer;
}

TEST(Diagnosis, FindsADiscriminantInAFloatThoughTCancels) {
  const Subject subject = subject_of("sphere", with_discriminant_in_float);
  const std::string found = in_words(faults_of(subject, *find_property("residual"), Precision::float64));
  EXPECT_TRUE(found.starts_with("discriminant-in-float ")) << found;
}

TEST(Diagnosis, TakesWhatMissesZeroForAPartOfWhatMissesSmallNumbers) {
  const Hypothesis &tangent = *find_hypothesis("tangent-missed"), &small = *find_hypothesis("larger-scene"),
                   &extreme = *find_hypothesis("ordinary-sizes"), &limit = *find_hypothesis("limit-1e6"),
                   &in_float = *find_hypothesis("computes-in-float");
  EXPECT_TRUE(is_part_of(tangent, small));
  EXPECT_FALSE(is_part_of(small, tangent));
  EXPECT_FALSE(is_part_of(tangent, limit));
  EXPECT_TRUE(is_part_of(extreme, limit));
  EXPECT_TRUE(is_part_of(extreme, small));
  EXPECT_TRUE(is_part_of(extreme, in_float) && is_part_of(small, in_float) && is_part_of(limit, in_float));
  EXPECT_FALSE(is_part_of(tangent, in_float));
  EXPECT_FALSE(is_part_of(tangent, extreme));
}

/// Right, but for rays along a plane, which hit at infinity.
Answer at_infinity_along_the_plane(const Case& one) {
  auto answer = std::get<RayAnswer>(oracle::answer(one));
  if (answer.contact == Contact::parallel) answer.hits.push_back(infinity<double>);
  return answer;
}

TEST(Diagnosis, NamesADivisionByZeroThatIsNotKeptFrom) {
  const Subject subject = subject_of("plane", at_infinity_along_the_plane);
  const std::string found = in_words(faults_of(subject, *find_property("residual"), Precision::float64));
  EXPECT_TRUE(found.starts_with("is-infinite ") || found.starts_with("parallel-hit ")) << found;
}

/// What the lectures print wrongly, and the cause of it.
struct Printed {
  const char* method;
  const char* property;
  const char* cause;
};

TEST(Diagnosis, NamesTheCauseOfEachMisprint) {
  for (const auto& [method, property, cause] : std::initializer_list<Printed>{
           {"quadratic/printed_b_4ac", "robust-residual", "small-b"},
           {"point_in_polygon/printed_parity", "robust-verdict", "level-vertex"},
           {"plane/printed_implicit", "robust-residual", "coefficients-missing"},
           {"plane/printed_parallel", "contact", "contact-parallel"},
           {"triangle/printed_parallelogram", "robust-verdict", "parallelogram"},
           {"triangle/printed_lambda2", "robust-verdict", "lambda2-second-sign"},
           {"triangle/printed_xy", "exact", "upright-z"},
           {"polygon/printed_parity", "robust-verdict", "level-vertex"},
           {"sphere/printed_2ac", "robust-residual", "over-constant"},
           {"sphere/printed_half_b", "robust-residual", "unit-direction"},
           {"sphere/printed_unit_direction", "robust-residual", "t-as-object-distance"},
           {"box/printed_slabs", "robust-verdict", "missed-in-face"},
           {"cylinder/printed", "robust-verdict", "segment"}})
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      const std::string found =
          in_words(faults_of(*find_subject(method), *find_property(property), precision, 60));
      EXPECT_TRUE(found.starts_with(std::string(cause) + " "))
          << method << " " << name_of(precision) << ": " << found;
    }
}

}  // namespace
}  // namespace rayproof::faulty
