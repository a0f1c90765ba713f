#include "properties/finding.hpp"

#include <gtest/gtest.h>

#include "case/reader.hpp"
#include "case/writer.hpp"

namespace rayproof {
namespace {

Finding some_finding() {
  Finding finding;
  finding.subject = find_subject("sphere/printed_2ac");
  finding.property = find_property("robust-residual");
  finding.one = read_case(
      R"({"id": "<&\"'>", "precision": "float32", "ray": {"origin": [0,0,0], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 0.1}})");
  Trial trial(*finding.subject, finding.one);
  finding.evidence = finding.property->show(trial);
  return finding;
}

TEST(Finding, IsWrittenAndReadBackAsTheSameCase) {
  const Finding finding = some_finding();
  const Replayed read = read_replayed(write_finding(finding));
  EXPECT_EQ(read.subject, "sphere/printed_2ac");
  EXPECT_EQ(read.property, "robust-residual");
  Case with_note = finding.one;
  with_note.note = finding.evidence.note;
  EXPECT_EQ(write_case(read.one), write_case(with_note));
}

TEST(Finding, ABareCaseCanBeReplayed) {
  const Finding finding = some_finding();
  const Replayed read = read_replayed(write_case(finding.one));
  EXPECT_EQ(read.subject, "");
  EXPECT_EQ(write_case(read.one), write_case(finding.one));
}

TEST(Finding, AWrongVerdictHasNoUlps) {
  Finding finding = some_finding();
  std::get<RayQuestion>(finding.one.question).ray.origin.x = 5;
  RayAnswer invented;
  invented.hits.push_back(1);
  finding.evidence = show_answer(finding.one, invented, "");
  EXPECT_NE(write_finding(finding).find("\"error_ulp\": null"), std::string::npos);
}

TEST(Finding, WhatIsNeitherAFindingNorACaseIsRefused) {
  EXPECT_THROW(static_cast<void>(read_replayed("[]")), Refusal);
  EXPECT_THROW(static_cast<void>(read_replayed(R"({"case": {}, "subject": "a", "property": "b"})")), Refusal);
  EXPECT_THROW(static_cast<void>(read_replayed(R"({"subject": "a"})")), Refusal);
}

}  // namespace
}  // namespace rayproof
