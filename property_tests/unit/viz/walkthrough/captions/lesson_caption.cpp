#include "unit/viz/walkthrough/captions/lesson_caption.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

/// "q = o + t·d = … = (1, 2, 3)": a value's own numbers, which stage_bits_test holds to the plain run.
bool is_equation(const StageStep& step, const std::string& sentence) {
  return std::any_of(step.values.begin(), step.values.end(),
                     [&](const StageValue& value) { return sentence.starts_with(value.name + " = "); });
}

}  // namespace

NumbersByName numbers_up_to(const Stage& stage, std::size_t step) {
  Walkthrough all;
  for (std::size_t i = 0; i <= step; ++i) {
    for (const StageValue& value : stage.steps[i].values)
      all.inputs.insert(all.inputs.end(), value.components.begin(), value.components.end());
  }
  return NumbersByName(all, 0);
}

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins =
        std::isdigit(static_cast<unsigned char>(text[i])) != 0 ||
        (text[i] == '-' && i + 1 < text.size() && std::isdigit(static_cast<unsigned char>(text[i + 1])) != 0);
    if (!begins) continue;
    char* end = nullptr;
    numbers.push_back(std::strtod(text.c_str() + i, &end));
    i = static_cast<std::size_t>(end - text.c_str());
  }
  return numbers;
}

void expect_true_sentences(const Stage& stage, const std::vector<CheckedClaim>& of_kernels,
                           const std::vector<LessonClaim>& of_lessons) {
  for (std::size_t i = 0; i < stage.steps.size(); ++i) {
    const StageStep& step = stage.steps[i];
    const NumbersByName n = numbers_up_to(stage, i);
    std::set<std::string> sentences;
    for (const std::string& text : {step.words, step.caption})
      for (const std::string& sentence : sentences_of(text)) sentences.insert(sentence);
    for (const std::string& sentence : sentences) {
      if (find_claim(of_kernels, sentence) != nullptr || is_equation(step, sentence)) continue;
      const auto claim = std::find_if(of_lessons.begin(), of_lessons.end(), [&](const LessonClaim& one) {
        return (*one.lesson == '\0' || stage.name == one.lesson) && fits(one.words, sentence);
      });
      SCOPED_TRACE(stage.name + ": " + step.title + ": " + sentence);
      if (claim == of_lessons.end()) {
        ADD_FAILURE() << "is no sentence that a check of unit/viz/walkthrough/captions knows";
      } else if (claim->check != nullptr) {
        claim->check({stage, i, n, sentence});
      }
    }
  }
}

}  // namespace rayproof::viz
