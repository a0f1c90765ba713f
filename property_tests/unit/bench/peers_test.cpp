#include "bench/peers/peer.hpp"

#include <gtest/gtest.h>

#include <set>

#include "bench/measuring/oracle_contender.hpp"
#include "generators/generators.hpp"
#include "oracle/oracle.hpp"

namespace rayproof::report {
namespace {

constexpr std::array precisions{Precision::float32, Precision::float64};

std::vector<Case> random_cases(const std::string& topic, Precision precision, std::size_t count) {
  std::vector<Case> cases;
  for (const Family& family : families())
    if (family.topic == topic && family.name == "random")
      for (std::uint64_t seed = 0; cases.size() < count; ++seed) {
        Case one = family.generate(seed, precision);
        const Ray<double>& ray = std::get<RayQuestion>(one.question).ray;
        if (ray.t_min == 0 && std::isinf(ray.t_max)) cases.push_back(std::move(one));
      }
  return cases;
}

TEST(Peers, AnswerNearlyAllRandomCasesRightlyByWhateverRoutine) {
  std::set<std::string> asked;
  for (const char* const topic : {"sphere", "triangle", "plane", "box"})
    for (const Precision precision : precisions) {
      const std::vector<Case> cases = random_cases(topic, precision, 200);
      for (const PeerRoutine& peer : peers_of(topic, precision)) {
        std::size_t taken = 0, wrong = 0, wrong_in_batch = 0;
        for (const Case& one : cases) {
          if (!peer.takes(one)) continue;
          ++taken;
          wrong += oracle::judge(one, peer.subject.answer(one)).wrong ? 1 : 0;
          if (peer.subject.answer_in_batch != nullptr)
            wrong_in_batch += oracle::judge(one, peer.subject.answer_in_batch(one)).wrong ? 1 : 0;
        }
        EXPECT_GT(taken, 150U) << peer.subject.full_name();
        EXPECT_LT(wrong, 10U) << peer.subject.full_name();
        EXPECT_LT(wrong_in_batch, 10U) << peer.subject.full_name();
        asked.insert(peer.subject.full_name());
      }
    }
  for (const char* const always : {"sphere/glm", "triangle/glm", "plane/glm", "triangle/cgal", "plane/cgal"})
    EXPECT_TRUE(asked.contains(always)) << always;
}

TEST(Peers, AreTimedInTheArrangementsInWhichTheyAreJudged) {
  for (const char* const topic : {"sphere", "triangle", "plane", "box"})
    for (const Precision precision : precisions) {
      const std::vector<Case> cases = random_cases(topic, precision, 64);
      for (const PeerRoutine& peer : peers_of(topic, precision)) {
        const std::vector<Contender> timed = peer.contenders(peer.subject.name, cases);
        ASSERT_EQ(timed.size(), peer.subject.answer_in_batch == nullptr ? 1U : 2U);
        for (const Contender& one : timed) {
          EXPECT_EQ(one.method, peer.subject.name);
          one.pass(cases.size());
          one.pass(cases.size() - 1);  // no multiple of a packet's size
        }
      }
    }
}

TEST(Peers, AreNotAskedWhatTheyExclude) {
  Case flat;
  flat.precision = Precision::float64;
  flat.question = RayQuestion{{{0, 0, -5}, {0, 0, 1}}, Triangle<double>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}};
  for (const PeerRoutine& peer : peers_of("triangle", Precision::float64))
    EXPECT_EQ(peer.takes(flat), peer.subject.name != "cgal") << "CGAL's manual excludes degenerate triangles";
}

TEST(Peers, AreAskedAboutNoInterval) {
  for (const auto& [t_min, t_max] : {std::pair{-1.0, 9.0}, std::pair{1.0, infinity<double>}}) {
    Case cut;
    cut.question = RayQuestion{{{0, 0, -5}, {0, 0, 1}, t_min, t_max}, Sphere<double>{{0, 0, 0}, 1}};
    for (const Precision precision : precisions) {
      cut.precision = precision;
      for (const PeerRoutine& peer : peers_of("sphere", precision)) EXPECT_FALSE(peer.takes(cut));
    }
  }
}

TEST(OracleContender, JudgesAsManyCasesAsItIsGiven) {
  const std::vector<Case> cases = random_cases("sphere", Precision::float32, 10);
  const Contender oracle = oracle_contender("sphere", cases);
  EXPECT_EQ(oracle.method, oracle_name);
  for (const auto& passes : time_passes({oracle}, cases.size(), 0.001))
    for (const double ns : passes) EXPECT_GT(ns, 0);
}

}  // namespace
}  // namespace rayproof::report
