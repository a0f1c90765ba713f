#pragma once
/// \file
/// Everything there is to tell of one case: the exact answer, a method's answer, and how it came to it.

#include <optional>
#include <string>
#include <vector>

#include "case/answer.hpp"
#include "case/case.hpp"
#include "viz/walkthrough.hpp"

namespace rayproof::viz {

/// One case, answered.
struct Told {
  Case one;
  Answer exact;
  std::string method{};             ///< "sphere/textbook"; empty where no method was asked
  std::optional<Answer> claimed{};  ///< the method's answer
  std::optional<Walkthrough> walk{};
  /// For a float32 case, the exact answer to 53 bits: where between two floats it lies. Else left out.
  std::optional<Answer> finer{};
  /// Where the method has no walk: methods of the topic that have one, the nearest names first.
  std::vector<std::string> recordable{};

  [[nodiscard]] const Answer* claim() const { return claimed ? &*claimed : nullptr; }
};

/// "t" or "x".
[[nodiscard]] std::string symbol_of(const Case& one);

/// One plain sentence, sometimes two: how far off the answer is, or where its digits were lost; and where an
/// answer is wrong though none were, why.
[[nodiscard]] std::string conclusion_of(const Told& told);

/// The explanation for a terminal, in UTF-8.
[[nodiscard]] std::string explain_text(const Told& told);

/// The same as one line of JSON.
[[nodiscard]] std::string explain_json(const Told& told);

/// The same, with the picture, as one HTML page that needs nothing from elsewhere.
[[nodiscard]] std::string html_page(const Told& told);

}  // namespace rayproof::viz
