#include <fmt/format.h>

#include "viz/answers.hpp"
#include "viz/numbers.hpp"
#include "viz/told.hpp"

namespace rayproof::viz {
namespace {

/// What a few roundings may be.
constexpr double a_few_ulps = 16;

/// Whether a root lies within its own rounding of an end of the ray's interval.
bool ends_decide(const Told& told) {
  const auto* question = std::get_if<RayQuestion>(&told.one.question);
  if (question == nullptr) return false;
  const auto is_near = [&](double a, double b) { return count_ulps(a, b, told.one.precision) <= a_few_ulps; };
  const auto is_at = [&](double root) {
    return is_near(root, question->ray.t_min) || is_near(root, question->ray.t_max);
  };
  return is_at(told.walk->lo) || is_at(told.walk->hi);
}

double ulps_of(const Told& told) { return worst_ulps(&told.exact, told.claim(), told.one.precision); }

/// The answer of a right verdict, as its numbers are counted: a miss or a place has none.
std::string accuracy_of(const Told& told) {
  return values_of(&told.exact).empty() ? "the exact one" : accuracy_in_words(ulps_of(told));
}

/// Of a method without steps to show.
std::string without_steps(const Told& told) {
  const bool differ = verdicts_differ(&told.exact, told.claim());
  std::string text = fmt::format("{} can't be recorded step by step; its answer is {}.", told.method,
                                 differ ? "not the exact one" : accuracy_of(told));
  if (!told.recordable.empty())
    text += fmt::format(" Methods that can be: {}.", fmt::join(told.recordable, ", "));
  return text;
}

/// How near a right answer is; an operation that lost digits on the way to it is named all the same.
std::string right_answer_in_words(const Told& told) {
  const double ulps = ulps_of(told);
  const std::string sentence = ulps == 0
                                   ? fmt::format("The answer is {}.", accuracy_of(told))
                                   : fmt::format("Rounding changed the answer by {} at most.", in_ulps(ulps));
  const Walkthrough& walk = *told.walk;
  if (walk.outcome == Outcome::faithful || !walk.death) return sentence;
  return fmt::format("{} In step '{}' {}.", sentence, walk.death->step, in_words(*walk.death));
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

}  // namespace

std::string in_words(const Measured& measured) {
  const std::string residual = fmt::format("the residual is {} contract units", rough(measured.residual));
  if (!measured.is_wrong) return residual;
  const std::string verdict =
      fmt::format("the verdict is wrong, {} contract units from a change of verdict", rough(measured.margin));
  return measured.residual > 0 ? verdict + "; " + residual : verdict;
}

std::string symbol_of(const Case& one) {
  return std::holds_alternative<RayQuestion>(one.question) ? "t" : "x";
}

std::string conclusion_of(const Told& told) {
  if (told.method.empty()) return "No method was asked, so there is nothing to compare.";
  if (!told.walk) return without_steps(told);
  if (!verdicts_differ(&told.exact, told.claim()) && ulps_of(told) <= a_few_ulps)
    return right_answer_in_words(told);
  const std::string sentence = verdict_sentence(*told.walk);
  if (told.walk->outcome != Outcome::faithful) return sentence;
  if (ends_decide(told)) {
    return sentence +
           " A root lies so near an end of the ray's interval that the last rounding decides the verdict.";
  }
  if (!told.walk->is_printed && verdicts_differ(&told.exact, told.claim()) && told.walk->decider.empty())
    return blame_of(*told.walk);
  const std::string why = told.walk->is_printed ? ": " + told.walk->known_fault + "." : ".";
  return sentence + " The answer is wrong all the same: the formula itself is at fault, not its rounding" +
         why;
}

}  // namespace rayproof::viz
