#pragma once
/// \file
/// The report on one case: the exact answer, a method's answer, and how it came to it; and what pictures
/// and texts say of answers.

#include <optional>
#include <string>
#include <vector>

#include "case/answer.hpp"
#include "case/case.hpp"
#include "viz/trace/walkthrough.hpp"

namespace rayproof::viz {

/// What the oracle measures of a method's answer, in the contract units of its topic
/// (docs/reading-a-check.md), as a bound without far_power has them.
struct Measured {
  bool is_wrong = false;  ///< the verdict
  double margin = 0;      ///< of a wrong verdict: how far the case is from a change of verdict
  double residual = 0;    ///< how far the answer misses its equation
};

struct CaseReport {
  Case one;
  Answer exact;
  std::string method{};             ///< "sphere/textbook"; empty where no method was asked
  std::optional<Answer> claimed{};  ///< the method's answer
  std::optional<Walkthrough> walk{};
  /// For a float32 case, the exact answer to 53 bits: where between two floats it lies. Else left out.
  std::optional<Answer> finer{};
  /// Where the method has no walk: methods of the topic that have one, the nearest names first.
  std::vector<std::string> recordable{};
  std::optional<Measured> measured{};  ///< of the method's answer

  [[nodiscard]] const Answer* claim() const { return claimed ? &*claimed : nullptr; }
};

/// "the verdict is wrong, 1.9e3 contract units from a change of verdict"; "the residual is 219 contract
/// units".
[[nodiscard]] std::string in_words(const Measured& measured);

/// What the method's run calls its hit or root of this rank, "t_entry"; "t₀" where it has no name for it.
[[nodiscard]] std::string root_name(const CaseReport& report, std::size_t rank);

/// What an exact hit or root of this rank is called beside it: as the steps call it, but by no name that is
/// the method's alone ("t_padded").
[[nodiscard]] std::string exact_root_name(const CaseReport& report, std::size_t rank);

/// "hit, t₀ = 1, t₁ = 2": what the method says.
[[nodiscard]] std::string answer_in_words(const CaseReport& report);

/// One plain sentence, sometimes two: how far off the answer is, or where its digits were lost; and where an
/// answer is wrong though none were, why.
[[nodiscard]] std::string conclusion_of(const CaseReport& report);
[[nodiscard]] std::string explain_text(const CaseReport& report);
[[nodiscard]] std::string explain_json(const CaseReport& report);

/// The t or x of the answer, ascending; none for a missing answer.
[[nodiscard]] std::vector<double> values_of(const Answer* answer);

/// "hit on an edge", "miss (parallel)", "two roots", "inside", "not given".
[[nodiscard]] std::string verdict_of(const Answer* answer);

/// Whether both are given and differ in how many hits or roots there are, of what kind, or in why there is
/// none.
[[nodiscard]] bool verdicts_differ(const Answer* exact, const Answer* claimed);

/// An exact value and the claimed one of the same rank.
struct ValuePair {
  std::size_t rank = 0;
  double exact = 0;
  double claimed = 0;
  double ulps = 0;  ///< between them, as count_ulps counts
};

/// The pair that lies farthest apart, infinite ones included; nothing where there is none to compare.
[[nodiscard]] std::optional<ValuePair> worst_pair(const Answer* exact, const Answer* claimed,
                                                  Precision precision);
/// Its distance in ulps; 0 where there is none.
[[nodiscard]] double worst_ulps(const Answer* exact, const Answer* claimed, Precision precision);

/// "Exact: hit. Claimed: miss, which is wrong." in one line.
[[nodiscard]] std::string headline_of(const Case& one, const Answer* exact, const Answer* claimed);

}  // namespace rayproof::viz
