#include <gtest/gtest.h>

#include <cmath>
#include <rayproof/topics.hpp>

#include "generators/generators.hpp"
#include "oracle/oracle.hpp"
#include "subjects/our_subject.hpp"
#include "subjects/reading.hpp"
#include "unit/bits.hpp"
#include "unit/viz/every_shape.hpp"
#include "viz/explain/case_report.hpp"
#include "viz/shapes/topics.hpp"
#include "viz/trace/record.hpp"

namespace rayproof::viz {
namespace {

TEST(Stories, OfEveryRecordableMethodEndInTheKernelsOwnNumbersBitForBit) {
  std::size_t explained = 0;
  for (const Family& family : families()) {
    const Case one = family.generate(7, Precision::float32);
    Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
      if (topic_of(one) != Topic::name) return;
      Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
        const auto walk = recorded_walk(one, Method::name);
        if constexpr (Recordable<Method, Recorded<float, Shadow>>) {
          ASSERT_TRUE(walk) << Topic::name << '/' << Method::name;
          const auto roots = solve_in<Topic, Method, float>(one);
          EXPECT_TRUE(same_bits<double>(walk->lo, roots.lo)) << Topic::name << '/' << Method::name;
          EXPECT_TRUE(same_bits<double>(walk->hi, roots.hi)) << Topic::name << '/' << Method::name;
          EXPECT_FALSE(walk->steps.empty()) << Topic::name << '/' << Method::name;
          ++explained;
        } else {
          EXPECT_FALSE(walk) << Topic::name << '/' << Method::name;
        }
      });
    });
  }
  EXPECT_GT(explained, 100U);
}

TEST(Stories, NameTheInputsByTheLettersOfTheFormat) {
  const auto names = [](const std::string& shape, const std::string& method) {
    const Case one = with_shape(shape);
    const Walkthrough walkthrough = recorded_walk(one, method).value();
    std::string all;
    for (const WalkValue& value : walkthrough.inputs) all += value.name + ' ';
    return all;
  };
  EXPECT_EQ(names(shapes_of("plane").front(), "implicit"), "o.x o.y o.z d.x d.y d.z n.x n.y n.z D ");
  EXPECT_EQ(names(shapes_of("plane")[2], "parametric"),
            "o.x o.y o.z d.x d.y d.z p.x p.y p.z u.x u.y u.z v.x v.y v.z ");
  EXPECT_EQ(names(shapes_of("triangle").front(), "cramer"),
            "o.x o.y o.z d.x d.y d.z a.x a.y a.z b.x b.y b.z c.x c.y c.z ");
  EXPECT_EQ(names(shapes_of("sphere").front(), "centred"), "o.x o.y o.z d.x d.y d.z C.x C.y C.z r ");
  EXPECT_EQ(names(shapes_of("cylinder").front(), "centred"), "o.x o.y o.z d.x d.y d.z rx ry height ");
}

TEST(Stories, AMethodThatCantBeRecordedSaysSoAndStillAnswers) {
  const Case one =
      read_case(R"({"query":"point_in_polygon","point":[0,0],"vertices":[[-1,-1],[1,-1],[0,1]]})");
  const CaseReport report{one, oracle::answer(one), "point_in_polygon/parity", Position::inside, {}};
  const std::string text = explain_text(report);
  EXPECT_NE(text.find("can't be recorded step by step; its answer is the exact one."), std::string::npos)
      << text;
  EXPECT_NE(text.find("inside"), std::string::npos) << text;
}

TEST(Stories, AComparisonBesideATieIsBlamedForAWrongVerdict) {
  const Case one = with_shape(shapes_of("triangle").front());
  const CaseReport report{one, oracle::answer(one), "triangle/woop", RayAnswer{}, recorded_walk(one, "woop")};
  EXPECT_NE(conclusion_of(report).find("a comparison is so near a tie"), std::string::npos)
      << conclusion_of(report);
}

}  // namespace
}  // namespace rayproof::viz
