#include <gtest/gtest.h>

#include "case/reader.hpp"
#include "properties/diagnosis/hypothesis.hpp"
#include "properties/guests/one_fault.hpp"
#include "properties/property.hpp"

namespace rayproof {
namespace {

FindingKind gravity(const Finding& finding) {
  return finding.property->claim == Claim::answers ? FindingKind::protocol : FindingKind::gross;
}

TEST(FindingsOfPrograms, ShowThatThereIsNoAnswerBesideAFaultOfMoreCases) {
  const Case one = read_case(
      R"({"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})");
  Subject guest;
  guest.has_own_contract = false;
  Finding silent{.subject = &guest, .property = find_property("answers"), .one = one};
  silent.evidence.no_answer = "crashed";
  silent.cases = 1;
  Finding wrong{.subject = &guest, .property = find_property("verdict"), .one = one};
  wrong.cause = find_hypothesis("ignores-t-min");
  wrong.cases = 1000;
  std::vector<Finding> findings{silent, wrong};
  const auto no = [](const Finding&) { return false; };
  put_together(findings, gravity, {no, no, [](const Finding&, const Finding&) { return false; }});
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings.front().property->claim, Claim::answers);
}

}  // namespace
}  // namespace rayproof
