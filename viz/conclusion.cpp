#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "viz/answers.hpp"
#include "viz/told.hpp"

namespace rayproof::viz {
namespace {

double epsilon(Precision precision) {
  return precision == Precision::float32 ? static_cast<double>(std::numeric_limits<float>::epsilon())
                                         : std::numeric_limits<double>::epsilon();
}

bool is_near(double a, double b, double ulps, Precision precision) {
  return a == b || (std::isfinite(b) &&
                    std::abs(a - b) <= ulps * epsilon(precision) * std::max(std::abs(a), std::abs(b)));
}

/// Whether a root lies within its own rounding of an end of the ray's interval.
bool ends_decide(const Told& told) {
  const auto* question = std::get_if<RayQuestion>(&told.one.question);
  if (question == nullptr) return false;
  const auto is_at = [&](double root) {
    return is_near(root, question->ray.t_min, 16, told.one.precision) ||
           is_near(root, question->ray.t_max, 16, told.one.precision);
  };
  return is_at(told.walk->lo) || is_at(told.walk->hi);
}

bool answers_agree(const Told& told) {
  if (verdicts_differ(&told.exact, told.claim())) return false;
  return worst_ulps(&told.exact, told.claim(), told.one.precision) <= 16;
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

std::string symbol_of(const Case& one) {
  return std::holds_alternative<RayQuestion>(one.question) ? "t" : "x";
}

std::string conclusion_of(const Told& told) {
  if (told.method.empty()) return "No method was asked, so there is nothing to compare.";
  const bool agree = answers_agree(told);
  if (!told.walk) {
    // A miss or a place has no ulps.
    return told.method + " can't be recorded step by step; its answer is " +
           (!agree                           ? "not the exact one."
            : values_of(&told.exact).empty() ? "right."
                                             : "right to a few ulps.");
  }
  const std::string sentence = verdict_sentence(*told.walk);
  if (agree || told.walk->outcome != Outcome::faithful) return sentence;
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
