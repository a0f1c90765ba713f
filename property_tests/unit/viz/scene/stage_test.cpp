#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "case/reader.hpp"
#include "unit/viz/stage_data.hpp"
#include "viz/page/page.hpp"
#include "viz/scene/shown_items.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
namespace {

TEST(Stage, ShowsDecimalsThatReadBackAsTheNumber) {
  for (const Lesson& lesson : lessons()) {
    const auto json = nlohmann::json::parse(stage_json(stage_of(lesson, report_lesson)));
    for (const auto& step : json["steps"]) {
      for (const auto& value : step["values"]) {
        for (const auto& component : value["components"]) {
          const double exact = number_in(component["value"]);
          if (!std::isfinite(exact)) continue;
          const std::string text = component["shown"];
          const double read =
              json["precision"] == "float32" ? static_cast<double>(std::stof(text)) : std::stod(text);
          EXPECT_EQ(read, exact) << lesson.name << ": " << value["name"] << " is shown as " << text;
        }
      }
    }
  }
}

TEST(Stage, EveryLessonHasFourToTenStepsAndEndsWithFloatAgainstExact) {
  std::set<std::string> names;
  for (const Lesson& lesson : lessons()) {
    EXPECT_TRUE(names.insert(lesson.name).second) << lesson.name << " is there twice";
    const Stage stage = stage_of(lesson, report_lesson);
    EXPECT_GE(stage.steps.size(), 4U) << lesson.name;
    EXPECT_LE(stage.steps.size(), 10U) << lesson.name;
    const bool compares_throughout = lesson.name == "acne" || lesson.name == "error-map";
    EXPECT_EQ(stage.steps.back().title == "Float result against exact result", !compares_throughout)
        << lesson.name;
    EXPECT_FALSE(stage.conclusion.empty()) << lesson.name;
    EXPECT_FALSE(stage.scene.empty()) << lesson.name;
    for (const StageStep& step : stage.steps) {
      EXPECT_FALSE(step.title.empty()) << lesson.name;
      EXPECT_FALSE(step.caption.empty()) << lesson.name << ": " << step.title;
      EXPECT_GT(step.view.radius, 0) << lesson.name << ": " << step.title;
    }
  }
}

TEST(Stage, EveryItemHasAsManyPointsAsItsFormTakesAllOfThemFinite) {
  for (const Lesson& lesson : lessons()) {
    const Stage stage = stage_of(lesson, report_lesson);
    const auto check = [&](const StageItem& item) {
      const std::size_t least = item.form == Form::point                                 ? 1
                                : item.form == Form::polygon || item.form == Form::solid ? 3
                                : item.form == Form::ellipsoid                           ? 4
                                                                                         : 2;
      EXPECT_GE(item.points.size(), least) << lesson.name << ": " << item.label;
      for (const glm::dvec3& p : item.points) {
        EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) << lesson.name;
      }
    };
    for (const StageItem& item : stage.scene) check(item);
    for (const StageStep& step : stage.steps) {
      for (const StageItem& item : step.items) check(item);
    }
  }
}

/// Where the stage's curve crosses the axis.
std::vector<double> zeros_of(const Stage& stage) {
  std::vector<double> zeros;
  for (const StageItem& item : stage.scene) {
    if (item.form != Form::polyline) continue;
    for (std::size_t i = 0; i + 1 < item.points.size(); ++i) {
      const glm::dvec3 &a = item.points[i], &b = item.points[i + 1];
      if (a.y * b.y <= 0 && a.y != b.y) zeros.push_back(a.x + (b.x - a.x) * a.y / (a.y - b.y));
    }
  }
  return zeros;
}

TEST(Stage, TheRootsOfAQuadraticAreMarkedWhereItsCurveCrossesTheAxis) {
  int count = 0;
  for (const char* lesson : {"quadratic-two", "quadratic-linear", "quadratic-viete"}) {
    const Stage stage = stage_of(*lessons_of(lesson).front(), report_lesson);
    const std::vector<double> zeros = zeros_of(stage);
    for (const StageStep& step : stage.steps) {
      for (const StageItem& item : step.items) {
        if (step.is_apart || item.form != Form::point || item.role != Role::claimed) continue;
        const bool is_marked = std::any_of(zeros.begin(), zeros.end(), [&](double zero) {
          return std::abs(zero - item.points[0].x) < 0.01;
        });
        EXPECT_TRUE(is_marked) << lesson << ": " << item.label;
        ++count;
      }
    }
  }
  EXPECT_GE(count, 5);
}

TEST(Stage, ASphereThatIsFarFromTheRaysStartIsLargeInEveryStep) {
  for (const char* lesson : {"far-sphere", "far-sphere-centred"}) {
    const Stage stage = stage_of(*lessons_of(lesson).front(), report_lesson);
    for (const StageStep& step : stage.steps) EXPECT_LT(step.view.radius, 3) << lesson << ": " << step.title;
    EXPECT_EQ(stage.steps.front().items.back().label, "← o, 4500 off") << lesson;
  }
}

TEST(Stage, CrossingsAtOnePlaceAreNamedTogetherAndOnce) {
  const Stage stage = stage_of(*lessons_of("polygon-vertex-trap").front(), report_lesson);
  std::vector<std::string> names;
  for (const ShownItem& shown : shown_in(stage, 3))
    if (shown.item->label.starts_with("crossing")) names.push_back(shown.item->label);
  EXPECT_EQ(names, std::vector<std::string>{"crossings 1 and 2"});
}

TEST(Stage, TheRootsOfADoubleRootAreBothNamed) {
  const Stage stage = stage_of(*lessons_of("quadratic-double").front(), report_lesson);
  std::set<std::string> names;
  for (const ShownItem& shown : shown_in(stage, 3)) names.insert(shown.item->label);
  EXPECT_TRUE(names.contains("x₀") && names.contains("x₁"));
}

TEST(Stage, TheDecisiveStepIsTheOneWithTheNumberThatWasSpoilt) {
  const Stage far = stage_of(*lessons_of("far-sphere").front(), report_lesson);
  EXPECT_EQ(far.steps.at(far.decisive_step).title, "Form the discriminant");
  const Stage near = stage_of(*lessons_of("sphere").front(), report_lesson);
  EXPECT_EQ(near.decisive_step, 0U);
}

TEST(Stage, TheTitlesOfAKernelsStepsAreTheCommentsInItsCode) {
  const Case one = read_case(lessons_of("sphere").front()->case_text);
  const Stage stage = stage_of(report_lesson(one, "sphere/centred"));
  ASSERT_EQ(stage.steps.size(), 7U);
  EXPECT_EQ(stage.steps[2].title, "Find the ray point nearest the centre (1\u00a0of\u00a02)");
  EXPECT_EQ(stage.steps[4].title, "Compare its distance with the radius");
  EXPECT_NE(stage.steps[5].caption.find("t₁ = t_c + h = 2.8512821 + 0.90387434 = 3.7551565"),
            std::string::npos)
      << stage.steps[5].caption;
}

TEST(Stage, PutsParenthesesAroundNamesThatAreSums) {
  const Stage stage = stage_of(*lessons_of("plane-implicit").front(), report_lesson);
  const std::string& caption = stage.steps.at(stage.steps.size() - 2).caption;
  EXPECT_NE(caption.find("t = −(n·o + D) / (n·d)"), std::string::npos) << caption;
}

TEST(Stage, CountsTheBitsLostOfANarrowedNumberInItsOwnPrecision) {
  const Stage stage = stage_of(*lessons_of("woop").front(), report_lesson);
  for (const StageStep& step : stage.steps) {
    for (const StageValue& value : step.values) {
      for (const WalkValue& v : value.components) EXPECT_LE(v.bits_lost, 24) << v.name;
    }
  }
}

TEST(Stage, ASlideOfAStepInPartsSaysWhatItsOwnNumbersLost) {
  const Stage stage = stage_of(*lessons_of("quadratic-cancellation").front(), report_lesson);
  int slides_that_lose = 0;
  for (const StageStep& step : stage.steps) {
    if (step.is_apart || !step.title.starts_with("Apply the quadratic formula")) continue;
    const bool cancels = step.digits.find("cancel") != std::string::npos;
    slides_that_lose += cancels ? 1 : 0;
    // b is negative: −b and √D cancel in their difference, x₀.
    EXPECT_EQ(cancels, step.values.back().name == "x₀") << step.title << ": " << step.digits;
  }
  EXPECT_EQ(slides_that_lose, 1);
}

TEST(Stage, NoNumberLosesMoreBitsThanItsFormatHas) {
  for (const Lesson& lesson : lessons()) {
    const Stage stage = stage_of(lesson, report_lesson);
    std::vector<std::string> sentences{stage.conclusion};
    for (const StageStep& step : stage.steps) sentences.push_back(step.digits);
    for (const std::string& sentence : sentences) {
      const std::size_t of = sentence.find(" of 24 bits");
      if (of == std::string::npos) continue;
      const std::size_t begin = sentence.rfind(' ', of - 1) + 1;
      EXPECT_LE(std::stod(sentence.substr(begin)), 24) << lesson.name << ": " << sentence;
    }
  }
}

TEST(Stage, ShowsTheWholeOfEveryPointAndArrowOfAStep) {
  for (const Lesson& lesson : lessons()) {
    const Stage stage = stage_of(lesson, report_lesson);
    if (lesson.compose != nullptr) continue;
    const bool starts_far = !stage.steps.front().items.empty();
    for (const StageStep& step : stage.steps) {
      if (step.is_apart || starts_far) continue;
      for (const StageItem& item : step.items) {
        if (item.form != Form::point && item.form != Form::arrow) continue;  // an interval may be infinite
        for (const glm::dvec3& p : item.points) {
          const glm::dvec3 off = p - step.view.centre;
          EXPECT_LE(std::abs(glm::dot(off, stage.camera.up)), step.view.radius * 1.001)
              << lesson.name << ": " << step.title << ": " << item.label;
          EXPECT_LE(std::abs(glm::dot(off, stage.camera.right)), step.view.radius * view_aspect * 1.001)
              << lesson.name << ": " << step.title << ": " << item.label;
        }
      }
    }
  }
}

TEST(Stage, ACaseWithoutAMethodHasTheSceneAndTheExactAnswer) {
  const Case one = read_case(lessons_of("sphere").front()->case_text);
  const Stage stage = stage_of(report_lesson(one, ""));
  ASSERT_EQ(stage.steps.size(), 2U);
  EXPECT_EQ(stage.steps.back().title, "The exact answer");
}

TEST(Lessons, HaveAMethodOrAComposerAndStandByGroups) {
  std::vector<std::string> groups;
  for (const Lesson& lesson : lessons()) {
    EXPECT_TRUE(lesson.compose != nullptr || find_subject(lesson.method) != nullptr) << lesson.name;
    if (groups.empty() || groups.back() != lesson.group) groups.push_back(lesson.group);
  }
  EXPECT_EQ(std::set(groups.begin(), groups.end()).size(), groups.size());
  for (const Composer& one : composers) EXPECT_EQ(lessons_of(one.lesson).size(), 1U) << one.lesson;
}

TEST(Lessons, AreFoundByNameByGroupAndAllTogether) {
  EXPECT_EQ(lessons_of("sphere").size(), 1U);
  EXPECT_GT(lessons_of("triangles").size(), 2U);
  EXPECT_EQ(lessons_of("all").size(), lessons().size());
  EXPECT_TRUE(lessons_of("no such topic").empty());
}

}  // namespace
}  // namespace rayproof::viz
