#include "dossier/collection.hpp"

#include <gtest/gtest.h>

namespace rayproof::dossier {
namespace {

FiledFinding found(const std::string& name, const std::string& shape, const std::string& diagnosis,
                   std::uint64_t cases) {
  FiledFinding filed;
  RecordedFinding& recorded = filed.dossier.recorded;
  recorded.name = name;
  recorded.shape = shape;
  recorded.kind = "gross";
  recorded.finding.diagnosis = diagnosis;
  recorded.finding.cases = cases;
  return filed;
}

TEST(Collection, OneDiagnosisInSeveralShapesIsOneFinding) {
  const auto kept = joined({found("bullet", "sphere", "only the smaller root is looked at", 500),
                            found("bullet", "box", "only the smaller root is looked at", 30),
                            found("bullet", "box", "only the smaller root is looked at", 7)});
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].recorded().finding.cases, 537U);
  EXPECT_EQ(kept[0].also_in, (std::vector{std::pair<std::string, std::string>("box", "bullet")}));
  EXPECT_EQ(also_in_words(kept[0]), "box");
  EXPECT_TRUE(kept[0].is_of({.shape = "sphere", .name = "bullet"}));
  EXPECT_TRUE(kept[0].is_of({.shape = "box", .name = "bullet"}));
  EXPECT_FALSE(kept[0].is_of({.shape = "plane", .name = "bullet"}));
}

TEST(Collection, OneDiagnosisOfOneFunctionIsOneFindingWhateverItsKind) {
  std::vector findings{found("glm", "sphere", "an absolute epsilon", 5),
                       found("glm-details", "sphere", "an absolute epsilon", 7),
                       found("glm-line", "triangle", "an absolute epsilon", 9)};
  findings[1].dossier.recorded.kind = "boundary";
  for (FiledFinding& one : findings) one.dossier.reproduction.function = "intersectRaySphere";
  findings[2].dossier.reproduction.function = "intersectLineTriangle";
  const auto kept = joined(std::move(findings));
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].recorded().finding.cases, 12U);
  EXPECT_EQ(also_in_words(kept[0]), "sphere/glm-details");
}

TEST(Collection, OtherSubjectsDiagnosesAndWhatNothingCuresStayApart) {
  const std::string unknown = "nothing that was tried cures it: wrong on 3 cases";
  const auto kept =
      joined({found("bullet", "sphere", "it is open there", 5), found("ode", "sphere", "it is open there", 5),
              found("bullet", "sphere", "it is rounding", 5), found("bullet", "sphere", unknown, 5),
              found("bullet", "box", unknown, 5)});
  EXPECT_EQ(kept.size(), 5U);
}

}  // namespace
}  // namespace rayproof::dossier
