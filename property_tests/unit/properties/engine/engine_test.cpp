#include "properties/engine/engine.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

#include "case/writer.hpp"
#include "properties/report/report.hpp"
#include "unit/properties/broken_subjects.hpp"

namespace rayproof {
namespace {

const std::atomic<bool> go_on{false};

Settings small_run() {
  Settings settings;
  settings.cases = 2000;
  settings.families = {"random"};
  settings.precisions = {Precision::float32};
  settings.properties = {"verdict", "residual", "ascending"};
  return settings;
}

RunResult run(const Plan& plan) { return run_plan(plan, {}, {}, go_on); }

TEST(Engine, ASubjectThatThrowsEndsTheRun) {
  const std::vector<Subject> all{
      broken::subject("sphere", [](const Case&) -> Answer { throw std::runtime_error("no answer"); })};
  EXPECT_THROW((void)run(make_plan(small_run(), all)), std::runtime_error);
}

TEST(Engine, FindsNothingInTheOracle) {
  const std::vector<Subject> all{broken::subject("sphere", broken::exactly)};
  const Plan plan = make_plan(small_run(), all);
  const RunResult result = run(plan);
  EXPECT_TRUE(result.findings.empty());
  EXPECT_TRUE(summarise(plan, result).is_success());
  EXPECT_EQ(result.units.at(0).tally.cases, 2000U);
}

TEST(Engine, FindsABrokenSubjectOnceForEachPropertyAndFails) {
  const std::vector<Subject> all{broken::subject("sphere", [](const Case& one) {
    return broken::changed_hits(one, [](double t) { return 2 * t + 1; });
  })};
  const Plan plan = make_plan(small_run(), all);
  const RunResult result = run(plan);
  EXPECT_EQ(result.findings.size(), 1U);
  EXPECT_EQ(result.findings.at(0).property->name, "residual");
  EXPECT_FALSE(summarise(plan, result).is_success());
}

TEST(Engine, AnUnrefutedDeclarationFailsAFullSearchOnly) {
  Subject honest = broken::subject("sphere", broken::exactly);
  honest.contract.holds = {};
  honest.contract.refuted[0] = {Claim::residual, "it is said to be wrong"};
  const std::vector<Subject> all{honest};
  Settings settings = small_run();
  settings.cases = 200;
  const Plan some = make_plan(settings, all);
  EXPECT_TRUE(summarise(some, run(some)).is_success());
  settings.families.clear();
  const Plan full = make_plan(settings, all);
  EXPECT_FALSE(summarise(full, run(full)).is_success());
}

TEST(Engine, TheResultDoesNotDependOnTheNumberOfJobs) {
  Settings settings = small_run();
  settings.properties.clear();
  settings.shapes = {"quadratic"};
  settings.methods = {"textbook"};
  settings.cases = 20'000;
  const auto report = [&](int jobs) {
    settings.jobs = jobs;
    const Plan plan = make_plan(settings);
    const RunResult result = run(plan);
    return json_report(plan, result, summarise(plan, result));
  };
  EXPECT_EQ(report(1), report(3));
}

TEST(Engine, StopsOnRequestAndSaysSo) {
  const std::atomic<bool> stop{true};
  const RunResult result = run_plan(make_plan(small_run()), {}, {}, stop);
  EXPECT_TRUE(result.was_interrupted);
  EXPECT_TRUE(result.findings.empty());
}

TEST(Engine, TheCorpusIsPutToEverySubjectOfItsTopic) {
  const std::vector<Subject> all{
      broken::subject("sphere", [](const Case&) -> Answer { return RayAnswer{}; })};
  const Plan plan = make_plan(small_run(), all);
  const Case hit = [] {
    Case one;
    one.question = RayQuestion{{{0, 0, -5}, {0, 0, 1}}, Sphere<double>{{0, 0, 0}, 1}};
    return one;
  }();
  const RunResult result = run_plan(plan, {hit}, {}, go_on);
  EXPECT_EQ(result.corpus_cases, 1U);
  ASSERT_FALSE(result.findings.empty());
  EXPECT_EQ(result.findings.at(0).family, "corpus");
}

TEST(Engine, AShrunkFindingHasNoNoteAndNoIdOfTheCaseItBeganAs) {
  const std::vector<Subject> all{
      broken::subject("sphere", [](const Case&) -> Answer { return RayAnswer{}; })};
  Case hit;
  hit.id = "7";
  hit.note = "far away, and off to one side";
  hit.question = RayQuestion{{{0.125, 0.25, -543.21}, {0, 0, 1}}, Sphere<double>{{0, 0, 0}, 1.5}};
  const RunResult result = run_plan(make_plan(small_run(), all), {hit}, {}, go_on);
  ASSERT_FALSE(result.findings.empty());
  EXPECT_EQ(result.findings.at(0).one.note, "");
  EXPECT_EQ(result.findings.at(0).one.id, "");
}

TEST(Engine, AnInterruptEndsTheShrinkingToo) {
  std::atomic<bool> stop{false};
  const std::vector<Subject> all{
      broken::subject("sphere", [](const Case&) -> Answer { return RayAnswer{}; })};
  Listener listener;
  Case as_found;
  listener.broken = [&](const Finding& finding) {
    as_found = finding.one;
    stop = true;
  };
  const RunResult result = run_plan(make_plan(small_run(), all), {}, listener, stop);
  ASSERT_EQ(result.findings.size(), 1U);
  EXPECT_EQ(write_case(result.findings.at(0).one), write_case(as_found));
}

TEST(Plan, AnUnknownNameIsRefusedInOneSentence) {
  Settings settings;
  settings.methods = {"centered"};
  EXPECT_THROW(static_cast<void>(make_plan(settings)), UnknownName);
  settings = {};
  settings.families = {"nowhere"};
  EXPECT_THROW(static_cast<void>(make_plan(settings)), UnknownName);
  settings = {};
  settings.shapes = {"quadratic"};
  settings.families = {"grazing"};
  EXPECT_THROW(static_cast<void>(make_plan(settings)), UnknownName);
}

}  // namespace
}  // namespace rayproof
