#pragma once
/// \file
/// A walkthrough: a method's run on one case, step by step, as data. Text, page and picture are sinks of
/// it.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "viz/picture/picture.hpp"
#include "viz/trace/expression.hpp"

namespace rayproof::viz {

struct PrecisionLoss {
  std::string step;           ///< the step's title
  std::string kind;           ///< "subtraction", "addition", "multiplication", …
  std::string effect;         ///< "cancels", "overflows and loses", "loses"
  std::string formula;        ///< "b·b − 4·a·c"
  std::string name;           ///< of its result, where it has one: "D"
  double bits_lost_here = 0;  ///< lost in this operation alone
  double bits_lost = 0;       ///< lost in its result
  int digits = 24;            ///< of the result's own format: a float kernel may compute a part in double
};

/// "the subtraction b·b − 4·a·c loses 22 of 24 bits by cancellation"
[[nodiscard]] std::string in_words(const PrecisionLoss& loss);

/// The same as a sentence; empty for no loss.
[[nodiscard]] std::string loss_sentence(const std::optional<PrecisionLoss>& loss);

/// A number the formula names, as it was rounded and as it should be.
struct WalkValue {
  std::string name;   ///< "D", "f.x"
  Formula formula{};  ///< what it was computed from, in named numbers: b·b − 4·a·c; null for an input
  double value = 0;   ///< in the method's arithmetic
  std::string
      exact;  ///< the same formula in real numbers, as exact_beside writes it; an input as it is stored
  double error = 0;        ///< value - exact, rounded to double
  double error_bound = 0;  ///< what running error analysis guarantees without knowing the exact value
  double bits_lost = 0;    ///< log2(1 + error in ulps), at most `digits`
  int digits = 24;         ///< of the value's own format: a float kernel may compute a part in double
  double exact_value = 0;  ///< `exact`, rounded to double
  std::optional<PrecisionLoss>
      loss{};  ///< the operation of its formula that loses most; none where none is worth it
};

struct WalkStep {
  std::string title;
  std::string meaning;    ///< in a sentence, its numbers put in
  std::string caption{};  ///< which operation lost digits; empty where none lost any worth a word
  std::vector<WalkValue> values{};
  std::optional<PrecisionLoss> loss{};  ///< what the caption says; none where none is worth it
};

/// How the float run came out beside the same formula in real numbers.
enum class Faithfulness {
  faithful,    ///< the answers agree to a few ulps, the verdict with them
  inaccurate,  ///< the answers have lost digits
  flipped      ///< the number whose sign decides has the wrong one: the verdict is noise
};

struct Walkthrough {
  std::string title;   ///< "sphere/textbook: quadratic formula in a, b, c"
  std::string source;  ///< author, title, year
  Precision precision = Precision::float32;
  int digits = 24;  ///< of the method's arithmetic
  std::vector<WalkValue> inputs{};
  std::vector<WalkStep> steps{};
  double lo = 0;  ///< the roots the method came to, ascending; NaN for none
  double hi = 0;
  Faithfulness outcome = Faithfulness::faithful;
  std::string decider = "the discriminant";  ///< the number whose sign decides; empty where comparisons do
  bool is_decider_zero = false;              ///< as it was computed
  std::string known_fault{};                 ///< why the method is known to go wrong; empty for a sound one
  bool is_printed = false;                   ///< copied from a source together with the source's error
  double answer_bits_lost = 0;  ///< of the worst answer, or of the flipped discriminant; 0 where faithful
  std::optional<PrecisionLoss>
      decisive_loss{};  ///< where they were lost; none where no single operation is to blame
  std::optional<PrecisionLoss>
      worst_loss{};  ///< the operation that lost most, whether or not the answer hangs on it
};

}  // namespace rayproof::viz
