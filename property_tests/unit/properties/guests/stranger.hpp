#pragma once
/// \file
/// Somebody else's code, as the tests of its trial need it.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include "subjects/default_contract.hpp"
#include "unit/properties/broken_subjects.hpp"

namespace rayproof {

inline const std::atomic<bool> never_stopped{false};

/// A subject without a contract of its own; a function, so that no process is needed.
[[nodiscard]] inline Subject guest(const std::string& topic, Answer (*answer)(const Case&)) {
  Subject made;
  made.topic = topic;
  made.name = "stranger";
  made.title = "somebody else's";
  made.contract = default_contract(topic);
  made.has_own_contract = false;
  made.start = [answer] { return std::make_unique<FunctionAnswerer>(answer); };
  return made;
}

[[nodiscard]] inline Answer nearest_alone(const Case& one) {
  auto answer = std::get<RayAnswer>(oracle::answer(one));
  answer.hits.count = std::min<std::size_t>(answer.hits.count, 1);
  answer.says_contact = false;
  answer.point.reset();
  answer.normal.reset();
  return answer;
}

[[nodiscard]] inline Answer verdict_alone(const Case& one) {
  RayAnswer answer;
  answer.verdict_only = std::get<RayAnswer>(oracle::answer(one)).hits.count > 0;
  if (answer.verdict_only) answer.hits.push_back(std::nan(""));
  return answer;
}

}  // namespace rayproof
