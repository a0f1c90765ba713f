#include <gtest/gtest.h>

#include <set>

#include "properties/claims/answers.hpp"
#include "subjects/default_contract.hpp"
#include "unit/diagnosis/clinic.hpp"
#include "unit/diagnosis/faulty/faulty.hpp"

namespace rayproof::faulty {
namespace {

/// A fault planted in the code of a topic, and the cause that must be named for the property it breaks.
struct Planted {
  const char* topic;
  Answer (*code)(const Case&);
  const char* property;
  const char* cause;
  Precision precision = Precision::float64;
};

using enum Fault;

const Planted planted[] = {
    {"sphere", answer<unit_direction>, "residual", "unit-direction"},
    {"sphere", answer<distance>, "residual", "t-as-distance"},
    {"sphere", answer<ignores_t_max>, "verdict", "ignores-t-max"},
    {"sphere", answer<ignores_t_min>, "verdict", "ignores-t-min"},
    {"sphere", answer<t_min_is_zero>, "verdict", "t-min-is-zero"},
    {"sphere", answer<open_interval>, "boundary", "open-interval"},
    {"sphere", answer<near_root_only>, "verdict", "first-hit-decides"},
    {"sphere", answer<far_root>, "verdict", "farthest-hit"},
    {"sphere", answer<one_admits_all>, "verdict", "one-hit-admits-all"},
    {"sphere", answer<descending>, "ascending", "descending"},
    {"sphere", answer<epsilon>, "verdict", "epsilon-1e-4"},
    {"sphere", answer<limited>, "verdict", "limit-1e5"},
    {"sphere", answer<segment>, "verdict", "segment"},
    {"sphere", answer<computes_in_float>, "residual", "computes-in-float"},
    {"sphere", answer<ignores_transform>, "verdict", "ignores-transform"},
    {"sphere", answer<inverse_transform>, "verdict", "inverse-transform"},
    {"sphere", answer<direction_translated>, "verdict", "direction-translated"},
    {"sphere", answer<origin_not_translated>, "verdict", "ignores-translation"},
    {"sphere", answer<object_distance>, "residual", "t-as-object-distance"},
    {"sphere", answer<normal_by_matrix>, "normal", "normal-by-matrix"},
    {"sphere", answer<normal_in_object>, "normal", "normal-in-object"},
    {"sphere", answer<normal_flipped>, "normal", "normal-flipped"},
    {"sphere", answer<normal_faces_ray>, "normal", "normal-faces-ray"},
    {"cylinder", answer<normal_not_unit>, "normal", "normal-not-unit"},
    {"sphere", answer<point_in_object>, "point", "point-in-object"},
    {"sphere", answer<point_without_origin>, "point", "point-without-origin"},
    {"triangle", answer<barycentric_order>, "coordinates", "barycentric-cba"},
    {"sphere", answer<radius_not_squared>, "verdict", "radius-rooted"},
    {"sphere", answer<radius_is_diameter>, "verdict", "radius-halved"},
    {"sphere", answer<centre_ignored>, "verdict", "centre-ignored"},
    {"sphere", answer<centre_negated>, "verdict", "centre-negated"},
    {"sphere", answer<denominator_2ac>, "residual", "over-constant"},
    {"sphere", answer<denominator_a>, "residual", "doubled"},
    {"sphere", answer<from_inside_missed>, "verdict", "misses-from-inside"},
    {"sphere", answer<tangent_missed>, "boundary", "tangent-missed"},
    {"triangle", answer<no_sum_test>, "verdict", "parallelogram"},
    {"triangle", answer<no_beta_test>, "verdict", "edge-b-not-tested"},
    {"triangle", answer<no_test>, "verdict", "whole-plane"},
    {"triangle", answer<culls_back>, "verdict", "culls-back-faces"},
    {"triangle", answer<absolute_epsilon>, "verdict", "larger-scene"},
    {"triangle", answer<edges_open>, "boundary", "boundary-outside"},
    {"triangle", answer<one_edge_open>, "boundary", "off-boundary"},
    {"triangle", answer<lambda_sign>, "verdict", "lambda2-second-sign"},
    {"triangle", answer<drops_z>, "verdict", "renamed-axes"},
    {"plane", answer<constant_sign>, "residual", "constant-negated"},
    {"plane", answer<constant_ignored>, "residual", "constant-ignored"},
    {"plane", answer<unit_normal>, "residual", "constant-as-distance"},
    {"plane", answer<one_sided>, "verdict", "culls-back-faces"},
    {"plane", answer<no_coefficients>, "residual", "coefficients-missing"},
    {"plane", answer<absolute_epsilon>, "verdict", "longer-direction"},
    {"polygon", answer<closed_sides>, "verdict", "level-vertex"},
    {"polygon", answer<winding>, "verdict", "winding-rule"},
    {"polygon", answer<last_side_missing>, "verdict", "last-side-missing"},
    {"polygon", answer<convex_only>, "verdict", "taken-as-convex"},
    {"polygon", answer<first_triangle>, "verdict", "first-triangle"},
    {"polygon", answer<culls_back>, "verdict", "culls-back-faces"},
    {"point_in_polygon", answer<closed_sides>, "verdict", "level-vertex"},
    {"point_in_polygon", answer<open_sides>, "verdict", "level-vertex"},
    {"point_in_polygon", answer<winding>, "verdict", "winding-rule"},
    {"point_in_polygon", answer<last_side_missing>, "verdict", "last-side-missing"},
    {"point_in_polygon", answer<convex_only>, "verdict", "taken-as-convex"},
    {"point_in_polygon", answer<first_triangle>, "verdict", "first-triangle"},
    {"box", answer<slab_z_missing>, "verdict", "endless-box-z"},
    {"box", answer<zero_times_infinity>, "verdict", "tilted"},
    {"box", answer<no_exchange>, "verdict", "positive-direction"},
    {"box", answer<starts_at_t_min>, "verdict", "starts-at-t-min"},
    {"box", answer<ignores_t_max>, "verdict", "ignores-t-max"},
    {"parallelepiped", answer<as_box>, "verdict", "parallelepiped-as-box"},
    {"parallelepiped", answer<edge_missing>, "verdict", "endless-edge-2"},
    {"parallelepiped", answer<distance>, "residual", "t-as-distance"},
    {"cylinder", answer<no_height>, "verdict", "endless-cylinder"},
    {"cylinder", answer<caps_always>, "verdict", "caps-added"},
    {"cylinder", answer<caps_never>, "verdict", "caps-missing"},
    {"cylinder", answer<circle>, "verdict", "circle-rx"},
    {"cylinder", answer<height_centred>, "verdict", "middle-at-zero"},
    {"cylinder", answer<segment>, "verdict", "segment"},
    {"quadratic", answer<no_linear>, "verdict", "linear-not-handled"},
    {"quadratic", answer<division_by_2>, "residual", "times-a"},
    {"quadratic", answer<denominator_a>, "residual", "doubled"},
    {"quadratic", answer<abs_discriminant>, "verdict", "discriminant-sign-lost"},
    {"quadratic", answer<double_twice>, "boundary", "double-hit-twice"},
    {"quadratic", answer<double_missed>, "boundary", "double-root-missed"},
    {"quadratic", answer<descending>, "ascending", "descending"},
    {"quadratic", answer<wrong_order>, "ascending", "positive-a"},
    {"quadratic", answer<cancelling>, "residual", "small-b", Precision::float32},
    {"quadratic", answer<cancelling>, "residual", "small-b"},
};

Subject subject_of(const char* topic, Answer (*code)(const Case&)) {
  Subject subject;
  subject.topic = topic;
  subject.name = "on_trial";
  subject.answer_by(code);
  subject.contract = default_contract(topic);
  subject.has_own_contract = false;
  return subject;
}

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

TEST(Diagnosis, FindsNothingGrossInRightCode) {
  for (const std::string& topic : topics()) {
    const Subject right = subject_of(topic.c_str(), answer<nothing>);
    for (const char* const property : {"verdict", "residual", "ascending"})
      for (const Precision precision : {Precision::float32, Precision::float64})
        for (const Diagnosis& group : faults_of(right, *find_property(property), precision, 60))
          EXPECT_NE(group.kind, FindingKind::gross) << topic << " " << property << ": " << group.sentence;
  }
}

/// Two faults in one: it culls back faces, and forgets an edge.
Answer two_faults(const Case& one) {
  const bool is_hit = !numbers_in(answer<nothing>(one)).empty();
  const Answer culled = answer<culls_back>(one);
  return is_hit && numbers_in(culled).empty() ? culled : answer<no_beta_test>(one);
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
           {"triangle/printed_xy", "exact", "renamed-axes"},
           {"polygon/printed_parity", "robust-verdict", "level-vertex"},
           {"sphere/printed_2ac", "robust-residual", "over-constant"},
           {"sphere/printed_half_b", "robust-residual", "unit-direction"},
           {"sphere/printed_unit_direction", "robust-residual", "t-as-object-distance"},
           {"box/printed_slabs", "robust-verdict", "tilted"},
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
