/// \file
/// The numbers that walkthroughs show, bit for bit those of the same code run in plain floating point.

#include <gtest/gtest.h>

#include <algorithm>

#include "case/reader.hpp"
#include "unit/bits.hpp"
#include "unit/viz/walkthrough/stage_bits/plain_runs.hpp"
#include "viz/page/page.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
namespace {

/// Every number that a step shows, components one by one.
NamedNumbers shown_in(const Json& step) {
  NamedNumbers shown;
  for (const auto& value : step["values"]) {
    const auto& components = value["components"];
    for (std::size_t k = 0; k < components.size(); ++k) {
      const std::string axis = components.size() == 1 ? "" : std::string(".") + "xyz"[k];
      shown.emplace_back(value["name"].get<std::string>() + axis, number_in(components[k]["value"]));
    }
  }
  return shown;
}

/// A name that is given twice has several numbers.
bool is_among(const NamedNumbers& numbers, const NamedNumbers::value_type& number) {
  return std::ranges::any_of(numbers, [&](const auto& one_of) {
    return one_of.first == number.first && same_bits(one_of.second, number.second);
  });
}

TEST(StageBits, AMethodsStepsShowTheNumbersOfThePlainKernel) {
  int compared = 0;
  for (const Lesson& lesson : lessons()) {
    if (lesson.compose != nullptr) continue;
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      Case one = read_case(lesson.case_text);
      one.precision = precision;
      const Json data = Json::parse(stage_json(stage_of(report_lesson(one, lesson.method))));
      const NamedNumbers plain = heard(one, lesson.method);
      NamedNumbers shown;
      // The last step compares, and repeats the number on which the answer hangs.
      const std::size_t last = data["steps"].size() - 1;
      for (const auto& repeated : shown_in(data["steps"][last]))
        EXPECT_TRUE(is_among(plain, repeated)) << lesson.name << ": " << repeated.first;
      for (std::size_t i = 1; i < last; ++i) {
        const NamedNumbers more = shown_in(data["steps"][i]);
        shown.insert(shown.end(), more.begin(), more.end());
      }
      NamedNumbers before;
      for (const auto& number : plain) {
        const std::size_t i = before.size();
        const bool is_next = i < shown.size() && shown[i].first == number.first;
        if (!is_next && is_among(before, number)) continue;  // named twice in a step, and shown once
        ASSERT_TRUE(is_next) << lesson.name << ": " << number.first;
        EXPECT_TRUE(same_bits(number.second, shown[i].second))
            << lesson.name << ": " << number.first << " is " << number.second << ", shown as "
            << shown[i].second;
        before.push_back(number);
        ++compared;
      }
      EXPECT_EQ(before.size(), shown.size()) << lesson.name;
    }
  }
  EXPECT_GT(compared, 200);
}

TEST(StageBits, AComposedLessonShowsTheNumbersOfTheLibrarysFunctions) {
  for (const Lesson& lesson : lessons()) {
    if (lesson.compose == nullptr) continue;
    const bool says_it_in_words =
        lesson.name == "acne" || lesson.name == "error-map" || lesson.name == "property-test";
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      Case one = read_case(lesson.case_text);
      one.precision = precision;
      const Json data = Json::parse(stage_json(lesson.compose(one, report_lesson)));
      int compared = 0;
      for (std::size_t i = 1; i < data["steps"].size(); ++i) {
        const Json& step = data["steps"][i];
        const NamedNumbers plain = precision == Precision::float32
                                       ? PlainRuns<float>(one, data).of(lesson.name, step["title"])
                                       : PlainRuns<double>(one, data).of(lesson.name, step["title"]);
        for (const auto& number : shown_in(step)) {
          EXPECT_TRUE(is_among(plain, number)) << lesson.name << " shows " << number.first << " = "
                                               << number.second << ", which no plain run has";
          ++compared;
        }
      }
      EXPECT_GT(compared, says_it_in_words ? -1 : 1) << lesson.name;
    }
  }
}

}  // namespace
}  // namespace rayproof::viz
