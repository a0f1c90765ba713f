#include <gtest/gtest.h>

#include "case/reader.hpp"
#include "properties/diagnosis/hypothesis.hpp"
#include "properties/guests/one_fault.hpp"
#include "properties/property.hpp"

namespace rayproof {
namespace {

FindingKind gravity(const Finding& finding) {
  return finding.property->claim == Claim::answers ? FindingKind::protocol : FindingKind::range;
}

/// What is left of a program that gave no answer to one case and is wrong on a thousand others.
std::vector<Finding> left_of_two(bool (*is_extreme)(const Finding&)) {
  const Case one = read_case(
      R"({"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})");
  static Subject guest;
  guest.has_own_contract = false;
  Finding silent{.subject = &guest, .property = find_property("answers"), .one = one};
  silent.evidence.no_answer = "crashed";
  silent.cases = 1;
  Finding wrong{.subject = &guest, .property = find_property("verdict"), .one = one};
  wrong.cause = find_hypothesis("ignores-t-min");
  wrong.cases = 1000;
  std::vector<Finding> findings{silent, wrong};
  const auto no = [](const Finding&) { return false; };
  put_together(findings, gravity,
               {no, no, [](const Finding&, const Finding&) { return false; }, is_extreme, no});
  return findings;
}

TEST(FindingsOfPrograms, ShowThatThereIsNoAnswerBesideAFaultOfMoreCases) {
  const std::vector<Finding> left = left_of_two([](const Finding&) { return false; });
  ASSERT_EQ(left.size(), 2U);
  EXPECT_EQ(left.front().property->claim, Claim::answers);
}

TEST(FindingsOfPrograms, CountAnOverflowWithAFaultOfRange) {
  const std::vector<Finding> left = left_of_two([](const Finding&) { return true; });
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left.front().property->claim, Claim::verdict);
}

}  // namespace
}  // namespace rayproof
