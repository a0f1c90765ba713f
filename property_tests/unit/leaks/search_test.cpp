/// \file
/// What rays at vertices and edges find out about the methods of triangles.

#include <gtest/gtest.h>

#include <cmath>

#include "leaks/text.hpp"
#include "oracle/oracle.hpp"

namespace rayproof::leaks {
namespace {

const std::atomic<bool> never{false};

Result search_with(const std::vector<const Subject*>& subjects, const std::string& mesh, int jobs = 0) {
  return search(make_mesh(mesh), subjects, {.rays = 20'000, .jobs = jobs}, never,
                [](double, const std::string&) {});
}

Subject answering(Answer (*answer)(const Case&)) {
  Subject subject = *find_subject("triangle/rounded");
  subject.name = "made for a test";
  subject.answer_by(answer);
  return subject;
}

TEST(Leaks, AreNoneInTheWatertightAndTheExactMethod) {
  const std::vector<const Subject*> tight{find_subject("triangle/woop"), find_subject("triangle/rounded")};
  for (const std::string& mesh : made_meshes()) {
    const Result result = search_with(tight, mesh);
    EXPECT_TRUE(broken_promises(result).empty()) << text_table(result);
    for (const Outcomes& one : result.outcomes) EXPECT_GT(one.total(one.rays), 5'000U) << mesh;
  }
}

TEST(Leaks, AreManyWhereEdgesAreJudgedByRoundedCoordinates) {
  const Result result = search_with({find_subject("triangle/moller_trumbore")}, "knot");
  for (const Outcomes& one : result.outcomes) {
    EXPECT_GT(one.total(one.leaks), 100U);
    EXPECT_GT(one.total(one.doubles), 10U);
    EXPECT_GT(one.leaks_from_inside, 10U);
    EXPECT_TRUE(one.first[0] && one.first[1]);
  }
}

TEST(Leaks, AreEveryRayOfWhoMissesAlways) {
  const Subject blind = answering([](const Case&) -> Answer { return RayAnswer{}; });
  const Result result = search_with({&blind}, "torus");
  for (const Outcomes& one : result.outcomes) EXPECT_EQ(one.total(one.leaks), one.total(one.rays));
  EXPECT_EQ(broken_promises(result).size(), 2U);
}

TEST(Leaks, AreNoneOfTheOracleAndHitsAtOnePlaceAreOne) {
  const Subject exact = answering([](const Case& one) { return oracle::answer(one); });
  const Result result = search_with({&exact}, "cube");
  EXPECT_TRUE(broken_promises(result).empty()) << text_table(result);
}

TEST(Leaks, AreNotCountedWhereThereIsNoAnswer) {
  struct Refusing final : Answerer {
    void answer(std::span<const Case> cases, std::span<Outcome> outcomes) override {
      for (std::size_t i = 0; i < cases.size(); ++i)
        outcomes[i] = cases[i].precision == Precision::float32
                          ? Outcome{.kind = OutcomeKind::unsupported}
                          : Outcome{.kind = OutcomeKind::refused, .sentence = "will not"};
    }
  };
  Subject mute = answering(nullptr);
  mute.function = nullptr;
  mute.has_own_contract = false;
  mute.start = [] { return std::make_unique<Refusing>(); };
  const Result result = search_with({&mute}, "cube");
  EXPECT_EQ(result.outcomes[0].total(result.outcomes[0].rays), 0U);
  EXPECT_GT(result.outcomes[0].unsupported, 5'000U);
  EXPECT_EQ(result.outcomes[0].failed, 0U);
  EXPECT_GT(result.outcomes[1].failed, 5'000U);
  EXPECT_EQ(result.outcomes[1].failure->second, "will not");
  EXPECT_EQ(broken_promises(result).size(), 1U) << text_table(result);
}

TEST(Leaks, AreJudgedOfWhoGivesNoT) {
  Subject whether = answering([](const Case& one) -> Answer {
    RayAnswer answer;
    answer.verdict_only = std::get<RayAnswer>(oracle::answer(one)).hits.count > 0;
    if (answer.verdict_only) answer.hits.push_back(std::nan(""));
    return answer;
  });
  whether.has_own_contract = false;
  const Result result = search_with({&whether}, "cube");
  EXPECT_TRUE(broken_promises(result).empty()) << text_table(result);
  EXPECT_GT(result.outcomes[0].total(result.outcomes[0].rays), 5'000U);
}

TEST(Leaks, AreTheSameForEveryNumberOfThreads) {
  const std::vector<const Subject*> methods{find_subject("triangle/cramer")};
  const Result alone = search_with(methods, "torus", 1), many = search_with(methods, "torus", 3);
  EXPECT_EQ(text_table(alone), text_table(many));
  EXPECT_EQ(case_lines(alone), case_lines(many));
}

TEST(Leaks, AreShownWithThePatchAndTheRay) {
  const Result result = search_with({find_subject("triangle/cramer")}, "torus");
  const std::string page = html_page(make_mesh("torus"), {}, result);
  EXPECT_NE(page.find("class=\"truth\""), std::string::npos);
  EXPECT_NE(page.find("class=\"ray\""), std::string::npos);
  EXPECT_EQ(page.find("http://www.w3.org/2000/svg") == std::string::npos, false);
  EXPECT_EQ(page.find("<script"), std::string::npos);
}

}  // namespace
}  // namespace rayproof::leaks
