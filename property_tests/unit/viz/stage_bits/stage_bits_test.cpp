/// \file
/// The numbers that walkthroughs show, bit for bit those of the same code run in plain floating point.

#include <gtest/gtest.h>

#include <algorithm>

#include "case/reader.hpp"
#include "unit/bits.hpp"
#include "unit/viz/stage_bits/plain_runs.hpp"
#include "viz/page/stage_json.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/stage_of.hpp"

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
      for (std::size_t i = 1; i < data["steps"].size(); ++i) {
        const NamedNumbers more = shown_in(data["steps"][i]);
        shown.insert(shown.end(), more.begin(), more.end());
      }
      ASSERT_EQ(plain.size(), shown.size()) << lesson.name;
      for (std::size_t i = 0; i < plain.size(); ++i) {
        EXPECT_EQ(plain[i].first, shown[i].first) << lesson.name;
        EXPECT_TRUE(same_bits(plain[i].second, shown[i].second))
            << lesson.name << ": " << plain[i].first << " is " << plain[i].second << ", shown as "
            << shown[i].second;
        ++compared;
      }
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
        for (const auto& [name, value] : shown_in(step)) {
          // A name that is given twice has several numbers.
          const auto is_it = [&name = name, &value = value](const auto& one_of) {
            return one_of.first == name && same_bits(one_of.second, value);
          };
          EXPECT_TRUE(std::any_of(plain.begin(), plain.end(), is_it))
              << lesson.name << " shows " << name << " = " << value << ", which no plain run has";
          ++compared;
        }
      }
      EXPECT_GT(compared, says_it_in_words ? -1 : 1) << lesson.name;
    }
  }
}

}  // namespace
}  // namespace rayproof::viz
