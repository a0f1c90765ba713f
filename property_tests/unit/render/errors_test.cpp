#include "viz/render/errors.hpp"

#include <numeric>

#include "unit/render/scenes.hpp"

namespace rayproof::render {
namespace {

class Errors : public SceneFiles {
 protected:
  [[nodiscard]] static ErrorImage errors_of(const RenderScene& scene, const std::string& shape,
                                            const std::string& method) {
    Methods methods = default_methods();
    methods[shape] = method;
    const auto tree = bounds_tree(scene);
    return find_errors(scene, trace_exactly(scene, tree, {}), trace(scene, methods, nullptr, {}), {});
  }
};

/// The far sphere of docs/scenes, smaller.
RenderScene far_sphere(std::pair<int, int> size) {
  return read_scene(RAYPROOF_SOURCE_DIR "/docs/scenes/far-sphere.json", {}, {{}, size});
}

void expect_totals_add_up(const ErrorImage& errors) {
  const Totals& totals = errors.totals;
  EXPECT_EQ(totals.pixels, errors.verdicts.size());
  EXPECT_EQ(totals.exact_hits, totals.hits + totals.wrong_misses + totals.wrong_objects);
  EXPECT_EQ(std::accumulate(totals.steps.begin(), totals.steps.end(), std::size_t{0}), totals.hits);
  const auto misses =
      static_cast<std::size_t>(std::count(errors.verdicts.begin(), errors.verdicts.end(), Verdict::miss));
  EXPECT_EQ(totals.pixels, misses + totals.hits + totals.wrong());
}

TEST_F(Errors, TheCompensatedSphereAgreesWithTheOracleOnEveryPixelOfTheFarSphere) {
  const ErrorImage errors = errors_of(far_sphere({160, 120}), "sphere", "compensated");
  EXPECT_EQ(errors.totals.wrong(), 0U);
  EXPECT_LE(errors.totals.worst_ulps, 1);
  EXPECT_GT(errors.totals.hits, 1000U);
  expect_totals_add_up(errors);
}

TEST_F(Errors, TheTextbookSphereIsWrongFarAway) {
  const ErrorImage errors = errors_of(far_sphere({160, 120}), "sphere", "textbook");
  EXPECT_GT(errors.totals.wrong_hits, 1000U);
  expect_totals_add_up(errors);
}

TEST_F(Errors, TheFormulasAsPrintedAreWrongInTheirOwnWays) {
  const RenderScene mixed = scene(scene_text(mixed_entries));
  for (const auto& [shape, method] :
       {std::pair("triangle", "printed_parallelogram"), std::pair("plane", "printed_implicit"),
        std::pair("cylinder", "printed"), std::pair("sphere", "printed_half_b")}) {
    const ErrorImage errors = errors_of(mixed, shape, method);
    EXPECT_GT(errors.totals.wrong(), 0U) << shape << '/' << method;
    expect_totals_add_up(errors);
  }
}

TEST_F(Errors, ATieIsNoWrongObject) {
  const RenderScene twins = scene(scene_text(sphere_entry + ", " + sphere_entry));
  const auto tree = bounds_tree(twins);
  const HitImage exact = trace_exactly(twins, tree, {});
  HitImage other = exact;
  for (ObjectIndex& object : other.object) object = object == no_object ? object : 1;
  const ErrorImage errors = find_errors(twins, exact, other, {});
  EXPECT_EQ(errors.totals.wrong(), 0U);
  EXPECT_EQ(errors.totals.hits, errors.totals.steps[0]);
}

TEST_F(Errors, VerdictsAndUlpsAreKeptApart) {
  const RenderScene one = scene(scene_text(sphere_entry, "[3, 1]"));
  HitImage exact(3, 1), claimed(3, 1);
  exact.object[0] = 0;
  exact.t[0] = 4;
  claimed.object[0] = 0;
  claimed.t[0] = 4 + 3 * 0x1p-21;  // three ulps of a float at 4
  claimed.object[1] = 0;
  claimed.t[1] = 1;
  exact.object[2] = 0;
  exact.t[2] = 2;
  const ErrorImage errors = find_errors(one, exact, claimed, {});
  EXPECT_EQ(errors.verdicts, (std::vector{Verdict::hit, Verdict::wrong_hit, Verdict::wrong_miss}));
  EXPECT_EQ(errors.ulps, (std::vector{3.0, 0.0, 0.0}));
  EXPECT_EQ(errors.totals.worst_ulps, 3);
  EXPECT_EQ(errors.totals.steps[step_of(3)], 1U);
}

TEST_F(Errors, TheGreatestFloatHasAnUlpToo) {
  const RenderScene one = scene(scene_text(sphere_entry, "[1, 1]"), {Precision::float32, {}});
  HitImage exact(1, 1), claimed(1, 1);
  exact.set(0, 0, Nearest<float>{std::numeric_limits<float>::max(), 0});
  claimed.set(0, 0, Nearest<float>{std::nextafter(std::numeric_limits<float>::max(), 0.0F), 0});
  EXPECT_EQ(find_errors(one, exact, claimed, {}).totals.worst_ulps, 1);
}

TEST(UlpSteps, HoldWhatTheirLabelsSay) {
  EXPECT_EQ(step_of(0), 0U);
  EXPECT_EQ(step_of(1), 1U);
  EXPECT_EQ(step_of(7), 2U);
  EXPECT_EQ(step_of(8), 3U);
  EXPECT_EQ(step_of(4095), 5U);
  EXPECT_EQ(step_of(HUGE_VAL), ulp_steps.size() - 1);
}

}  // namespace
}  // namespace rayproof::render
