#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/explain/case_report.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

/// "In step 'Form the discriminant' the subtraction b·b − 4·a·c loses 22 of 24 bits by cancellation: …", or
/// that rounding changed little.
std::string verdict_sentence(const Walkthrough& walk) {
  if (walk.outcome == Faithfulness::faithful) {
    return std::isfinite(walk.lo) ? "Rounding changed the result of the formula by a few ulps at most."
                                  : "Rounding is not to blame.";
  }
  const std::string consequence =
      walk.outcome == Faithfulness::flipped
          ? walk.decider + (walk.is_decider_zero ? " is left 0" : " is left with the wrong sign") +
                ", and the verdict is wrong"
          : fmt::format("the answer keeps {:.0f} of its {} bits",
                        std::max(0.0, walk.digits - walk.answer_bits_lost), walk.digits);
  if (!walk.decisive_loss)
    return "No single operation is to blame, but roundings add up: " + consequence + ".";
  return fmt::format("In step '{}' {}: {}.", walk.decisive_loss->step, in_words(*walk.decisive_loss),
                     consequence);
}

/// What a few roundings may be.
constexpr double a_few_ulps = 16;

/// Whether a root lies within its own rounding of an end of the ray's interval.
bool ends_decide(const CaseReport& report) {
  const auto* question = std::get_if<RayQuestion>(&report.one.question);
  if (question == nullptr) return false;
  const auto is_near = [&](double a, double b) {
    return count_ulps(a, b, report.one.precision) <= a_few_ulps;
  };
  const auto is_at = [&](double root) {
    return is_near(root, question->ray.t_min) || is_near(root, question->ray.t_max);
  };
  return is_at(report.walk->lo) || is_at(report.walk->hi);
}

double ulps_of(const CaseReport& report) {
  return worst_ulps(&report.exact, report.claim(), report.one.precision);
}

/// The answer of a right verdict, as its numbers are counted: a miss or a place has none.
std::string accuracy_of(const CaseReport& report) {
  return values_of(&report.exact).empty() ? "the exact one" : accuracy_in_words(ulps_of(report));
}

std::string without_steps(const CaseReport& report) {
  const bool differ = verdicts_differ(&report.exact, report.claim());
  std::string text = fmt::format("{} can't be recorded step by step; its answer is {}.", report.method,
                                 differ ? "not the exact one" : accuracy_of(report));
  if (!report.recordable.empty())
    text += fmt::format(" Methods that can be: {}.", fmt::join(report.recordable, ", "));
  return text;
}

/// How near a right answer is; an operation that lost digits is named all the same.
std::string right_answer_in_words(const CaseReport& report) {
  const double ulps = ulps_of(report);
  const std::string sentence =
      ulps == 0 ? fmt::format("The answer is {}.", accuracy_of(report))
                : fmt::format("The answer is within {} of the exact one, correctly rounded.", in_ulps(ulps));
  const Walkthrough& walk = *report.walk;
  if (walk.outcome == Faithfulness::faithful || !walk.decisive_loss) return sentence;
  return fmt::format("{} In step '{}' {}.", sentence, walk.decisive_loss->step,
                     in_words(*walk.decisive_loss));
}

/// Of a wrong verdict to which the digits of no answer lead: no number's sign decided it, but comparisons.
std::string blame_of(const Walkthrough& walk) {
  std::string blame = "The verdict is wrong: ";
  if (!walk.known_fault.empty()) return blame + walk.known_fault + ".";
  blame += "a comparison is so near a tie that rounding takes the wrong side of it";
  if (!walk.worst_loss) return blame + ".";
  return blame + fmt::format("; most is lost in step '{}', where {}.", walk.worst_loss->step,
                             in_words(*walk.worst_loss));
}

std::string symbol_of(const Case& one) {
  return std::holds_alternative<RayQuestion>(one.question) ? "t" : "x";
}

/// A name that the steps have for the hit or root of this rank, whatever its value.
std::string usual_root_name(const CaseReport& report, std::size_t rank) {
  const std::string symbol = symbol_of(report.one), usual = symbol + subscript(rank);
  if (!report.walk) return usual;
  for (const std::string& name : {usual, std::string(rank == 0 ? "t_entry" : "t_exit"), symbol})
    for (const WalkStep& step : report.walk->steps)
      if (std::ranges::find(step.values, name, &WalkValue::name) != step.values.end()) return name;
  return usual;
}

}  // namespace

std::string in_words(const Measured& measured) {
  const std::string residual = fmt::format("the residual is {} contract units", rough(measured.residual));
  if (!measured.is_wrong) return residual;
  const std::string verdict =
      std::isinf(measured.margin)
          ? "the verdict is wrong, and no input near it has another verdict"
          : fmt::format("the verdict is wrong, {} contract units from a change of verdict",
                        rough(measured.margin));
  return measured.residual > 0 ? verdict + "; " + residual : verdict;
}

std::string root_name(const CaseReport& report, std::size_t rank) {
  const std::string usual = usual_root_name(report, rank);
  const std::vector<double> roots = values_of(report.claim());
  if (!report.walk || rank >= roots.size()) return usual;  // what it did not find has a name for all the same
  std::vector<std::string> equal;                          // the last first
  for (const WalkStep& step : report.walk->steps)
    for (const WalkValue& value : step.values)
      if (value.name.starts_with(symbol_of(report.one)) && value.value == roots[rank])
        equal.insert(equal.begin(), value.name);
  if (std::ranges::find(equal, usual) != equal.end()) return usual;
  // Of equal roots the later rank has the later name.
  const auto next = roots.begin() + static_cast<std::ptrdiff_t>(rank + 1);
  const auto later = static_cast<std::size_t>(std::count(next, roots.end(), roots[rank]));
  return later < equal.size() ? equal[later] : usual;
}

std::string exact_root_name(const CaseReport& report, std::size_t rank) {
  const std::string name = root_name(report, rank), symbol = symbol_of(report.one);
  const bool is_common = name == symbol || name == symbol + subscript(0) || name == symbol + subscript(1) ||
                         name == "t_entry" || name == "t_exit";
  return is_common ? name : usual_root_name(report, rank);
}

std::string answer_in_words(const CaseReport& report) {
  std::string words = verdict_of(report.claim());
  const std::vector<double> values = values_of(report.claim());
  for (std::size_t i = 0; i < values.size(); ++i)
    words += fmt::format(", {} = {}", root_name(report, i), shown(values[i], report.one.precision));
  return words;
}

std::string conclusion_of(const CaseReport& report) {
  if (report.method.empty()) return "No method was asked, so there is nothing to compare.";
  if (!report.claimed) return report.method + " gives no answer, so there is nothing to compare.";
  if (!report.walk) return without_steps(report);
  if (!verdicts_differ(&report.exact, report.claim()) && ulps_of(report) <= a_few_ulps)
    return right_answer_in_words(report);
  const std::string sentence = verdict_sentence(*report.walk);
  if (report.walk->outcome != Faithfulness::faithful) return sentence;
  if (ends_decide(report)) {
    return sentence +
           " A root lies so near an end of the ray's interval that the last rounding decides the verdict.";
  }
  if (!report.walk->is_printed && verdicts_differ(&report.exact, report.claim()) &&
      report.walk->decider.empty())
    return blame_of(*report.walk);
  const std::string why = report.walk->is_printed ? ": " + report.walk->known_fault + "." : ".";
  return sentence +
         " The answer is wrong all the same, for the formula itself is at fault, not its rounding" + why;
}

}  // namespace rayproof::viz
