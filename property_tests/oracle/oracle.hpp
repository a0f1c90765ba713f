#pragma once
/// \file
/// The oracle: exact answers to cases, and exact judgement of other people's answers. Slow, final, and
/// independent of every method it judges: it shares the case, never a formula.

#include "case/answer.hpp"
#include "case/case.hpp"
#include "oracle/judge/judgement.hpp"

namespace rayproof::oracle {

/// The exact answer of a valid case, rounded once at the end as the case format says.
[[nodiscard]] Answer answer(const Case& one);

/// Judges `claimed` against the exact truth of `one`. Certain in every bit that decides a verdict; errors are
/// certain to 2^-20 of their value or 2^-30 ulp, whichever is larger.
[[nodiscard]] Judgement judge(const Case& one, const Answer& claimed);

}  // namespace rayproof::oracle
