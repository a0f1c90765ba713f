#pragma once
/// \file
/// Subjects that are wrong on purpose, each in one way: what the properties must notice.

#include <cmath>
#include <string>

#include "oracle/oracle.hpp"
#include "properties/engine/plan.hpp"
#include "properties/numbers.hpp"

namespace rayproof::broken {

/// The oracle itself as a subject: it keeps every claim. It knows finite numbers alone, so NaN is a miss
/// here.
[[nodiscard]] inline Answer exactly(const Case& asked) {
  Case one = asked;
  for (const CaseNumber& number : numbers_of(one)) {
    if (std::isnan(*number.value)) return {};
  }
  return oracle::answer(one);
}

/// A subject of the topic that holds itself to everything and answers by `answer`.
[[nodiscard]] inline Subject subject(const std::string& topic, Answer (*answer)(const Case&)) {
  Subject made;
  made.topic = topic;
  made.name = "on_purpose";
  made.title = "wrong on purpose";
  made.answer_by(answer);
  made.answer_in_batch = answer;
  const Bound tight{.measured = 0, .promised = 1};
  made.contract.verdict = {.measured = 0, .promised = 0};
  made.contract.residual = tight;
  made.contract.ulp = tight;
  const Bound of_hit{.measured = 0, .promised = 4};
  made.contract.hit = {of_hit, of_hit, of_hit};
  made.contract.holds =
      Claims{Claim::verdict, Claim::residual, Claim::ulp,      Claim::robust,     Claim::ascending,
             Claim::moved,   Claim::scaled,   Claim::reversed, Claim::batch,      Claim::nan,
             Claim::bounded, Claim::point,    Claim::normal,   Claim::coordinates};
  return made;
}

/// The exact hits changed by `change`, which gets each t.
template <class Change>
[[nodiscard]] Answer changed_hits(const Case& one, Change&& change) {
  auto answer = std::get<RayAnswer>(exactly(one));
  for (std::size_t i = 0; i < answer.hits.count; ++i) answer.hits.t.at(i) = change(answer.hits.t.at(i));
  return answer;
}

}  // namespace rayproof::broken
