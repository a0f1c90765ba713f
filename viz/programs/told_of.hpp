#pragma once
/// \file
/// A case answered by the oracle and by a method, and the method's run told.

#include <optional>
#include <string>

#include "oracle/oracle.hpp"
#include "subjects/subject.hpp"
#include "viz/told.hpp"
#include "viz/topics.hpp"

namespace rayproof::viz {

/// `subject` may be null: then the exact answer alone. Its topic must be the case's.
[[nodiscard]] inline Told told_of(const Case& one, const Subject* subject) {
  Told told{one, oracle::answer(one), {}, {}, {}, {}};
  if (one.precision == Precision::float32) {
    Case finer = one;
    finer.precision = Precision::float64;
    told.finer = oracle::answer(finer);
  }
  if (subject == nullptr) return told;
  told.method = subject->full_name();
  told.claimed = subject->answer(one);
  if (const TopicView* view = view_of(one)) told.walk = view->walk(one, subject->name);
  return told;
}

/// The same by the method's name, as in "sphere/centred"; empty for none. A method of another topic or of no
/// topic at all is no method of the case: then the exact answer alone.
[[nodiscard]] inline Told told_of(const Case& one, const std::string& method) {
  const Subject* const subject = find_subject(method);
  return told_of(one, subject != nullptr && subject->topic == topic_of(one) ? subject : nullptr);
}

}  // namespace rayproof::viz
