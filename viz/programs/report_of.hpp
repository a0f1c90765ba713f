#pragma once
/// \file
/// A case answered by the oracle and by a method, with the walkthrough of the method.

#include <optional>
#include <string>
#include <vector>

#include "case/reader/near_names.hpp"
#include "oracle/oracle.hpp"
#include "subjects/subject.hpp"
#include "viz/explain/case_report.hpp"
#include "viz/shapes/topics.hpp"

namespace rayproof::viz {

/// Methods of the case's topic whose steps can be recorded, three at most, the names nearest to `method`
/// first.
[[nodiscard]] inline std::vector<std::string> recordable_methods(const Case& one, const std::string& method) {
  std::vector<std::string> names;
  for (const Subject& subject : subjects()) {
    if (subject.topic == topic_of(one) && recorded_walk(one, subject.name))
      names.push_back(subject.full_name());
  }
  return near_names(method, std::move(names), 3);
}

/// `subject` may be null: then the exact answer alone. Its topic must be the case's.
[[nodiscard]] inline CaseReport report_of(const Case& one, const Subject* subject) {
  CaseReport report{.one = one, .exact = oracle::answer(one)};
  if (one.precision == Precision::float32) {
    Case finer = one;
    finer.precision = Precision::float64;
    report.finer = oracle::answer(finer);
  }
  if (subject == nullptr) return report;
  report.method = subject->full_name();
  report.claimed = subject->answer(one);
  const oracle::Judgement judged = oracle::judge(one, *report.claimed);
  report.measured = {judged.wrong, judged.margin, judged.residual};
  report.walk = recorded_walk(one, subject->name);
  if (!report.walk) report.recordable = recordable_methods(one, report.method);
  return report;
}

/// The same by the method's name, as in "sphere/centred"; empty for none. A method of another topic or of no
/// topic at all is no method of the case: then the exact answer alone.
[[nodiscard]] inline CaseReport report_of(const Case& one, const std::string& method) {
  const Subject* const subject = find_subject(method);
  return report_of(one, subject != nullptr && subject->topic == topic_of(one) ? subject : nullptr);
}

}  // namespace rayproof::viz
