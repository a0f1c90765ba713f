#pragma once
/// \file
/// The sentences that lessons add to the kernels' own, and what tests hold them to.

#include "unit/viz/walkthrough/captions/caption.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// What a lesson's step says, and the exact numbers that the stage has shown up to it.
struct LessonSaid {
  const Stage& stage;
  std::size_t step;
  const NumbersByName& n;
  const std::string& sentence;
};

/// As CheckedClaim, of one lesson's sentence; of any lesson's, where its name is empty.
struct LessonClaim {
  const char* lesson;
  const char* words;
  void (*check)(const LessonSaid& said) = nullptr;
};

[[nodiscard]] std::vector<LessonClaim> comparison_claims();
[[nodiscard]] std::vector<LessonClaim> ray_lesson_claims();
[[nodiscard]] std::vector<LessonClaim> flat_lesson_claims();
[[nodiscard]] std::vector<LessonClaim> polygon_lesson_claims();
[[nodiscard]] std::vector<LessonClaim> solid_lesson_claims();
[[nodiscard]] std::vector<LessonClaim> surface_lesson_claims();
[[nodiscard]] std::vector<LessonClaim> number_lesson_claims();

/// Every sentence of the stage that is no kernel's is known, and true.
void expect_true_sentences(const Stage& stage, const std::vector<CheckedClaim>& of_kernels,
                           const std::vector<LessonClaim>& of_lessons);

/// All that the stage's steps show, up to the given one.
[[nodiscard]] NumbersByName numbers_up_to(const Stage& stage, std::size_t step);

/// The numbers in a text, in their order.
[[nodiscard]] std::vector<double> numbers_in(const std::string& text);

}  // namespace rayproof::viz
