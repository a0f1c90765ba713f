#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "case/reader.hpp"
#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "oracle/oracle.hpp"
#include "subjects/subject.hpp"
#include "unit/viz/picture/markup.hpp"
#include "unit/viz/stage_data.hpp"
#include "viz/explain/case_report.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/page/page.hpp"
#include "viz/picture/picture.hpp"
#include "viz/shapes/topics.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
namespace {

/// Every number an element has in pixels.
std::vector<Point> points_of(const Element& element) {
  struct {
    std::vector<Point> operator()(const PixelLine& e) const { return e.points; }
    std::vector<Point> operator()(const Area& e) const {
      std::vector<Point> all;
      for (const auto& ring : e.rings) all.insert(all.end(), ring.begin(), ring.end());
      return all;
    }
    std::vector<Point> operator()(const Mark& e) const { return {e.at}; }
    std::vector<Point> operator()(const Text& e) const { return {e.at}; }
  } visitor;
  return std::visit(visitor, element);
}

/// The text's width as DejaVu Sans has it, within a few percent.
double width_of(const Text& text) {
  const auto characters =
      std::count_if(text.text.begin(), text.text.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return static_cast<double>(characters) * text.size * (text.bold ? 0.66 : 0.58);
}

void expect_in_bounds(const Picture& picture, const std::string& which) {
  for (const Element& element : picture.elements) {
    for (const Point& p : points_of(element)) {
      ASSERT_TRUE(p.x >= 0 && p.x <= picture.width && p.y >= 0 && p.y <= picture.height)
          << which << ": " << p.x << ' ' << p.y;
    }
    if (const auto* text = std::get_if<Text>(&element); text != nullptr && text->anchor == Anchor::start) {
      ASSERT_LE(text->at.x + width_of(*text), picture.width + 1) << which << ": " << text->text;
    }
  }
}

/// This many cases of every family and precision as every method answers them; an answer that several methods
/// give makes one picture, and is checked once.
template <class Check>
void for_every_family(std::uint64_t cases, Check&& check) {
  for (const Family& family : families()) {
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      for (std::uint64_t seed = 0; seed < cases; ++seed) {
        const Case one = family.generate(seed, precision);
        const Answer exact = oracle::answer(one);
        std::set<std::pair<std::string, bool>> drawn;
        for (const Subject& subject : subjects()) {
          if (subject.topic != family.topic) continue;
          const Answer claimed = subject.answer(one);
          const auto* hits = std::get_if<RayAnswer>(&claimed);
          const bool is_nearest_only = hits != nullptr && hits->nearest_only;
          if (!drawn.emplace(write_answer(one, claimed), is_nearest_only).second) continue;
          check(one, exact, claimed, subject.full_name() + " on " + family.name + " " + std::to_string(seed));
        }
      }
    }
  }
}

TEST(Markup, IsRefusedForATagThatIsNoneOrOpenOrClosesNothing) {
  for (const char* right : {"", "text", "<a/>", "<a b=\"c\"  d-e=\"\"></a>", "<a><b/></a>"})
    EXPECT_EQ(complaint_about_xml(right), "") << right;
  for (const char* wrong : {"<a", "<a>", "</a>", "<a></b>", "<a b></a>", "<a b=c></a>", "<a b=\"c></a>",
                            "<a b=\"c\"d=\"e\"></a>", "<a b=\"<\"></a>", "< a></a>"})
    EXPECT_NE(complaint_about_xml(wrong), "") << wrong;
}

TEST(Picture, NothingLiesOutsideItWhateverTheCase) {
  for_every_family(3,
                   [](const Case& one, const Answer& exact, const Answer& claimed, const std::string& which) {
                     const CaseReport report{.one = one, .exact = exact, .claimed = claimed};
                     expect_in_bounds(case_picture(report), which);
                   });
}

TEST(Markup, IsRefusedForAnInfinityInAnAttributeAndNowhereElse) {
  EXPECT_EQ(complaint_about_numbers(R"(<a x="inf"/>)"), "inf");
  EXPECT_EQ(complaint_about_numbers(R"(<a d="M1 -inf"/>)"), "M1 -inf");
  EXPECT_EQ(complaint_about_numbers(R"(<a id="reinforced">inf</a>)"), "");
}

TEST(Picture, ItsSvgIsWellFormedAndNeedsNothingFromElsewhere) {
  for_every_family(1,
                   [](const Case& one, const Answer& exact, const Answer& claimed, const std::string& which) {
                     const std::string svg = case_still(one, &exact, &claimed);
                     ASSERT_EQ(complaint_about_xml(svg), "") << which;
                     ASSERT_EQ(complaint_about_addresses(svg), "") << which;
                     ASSERT_EQ(svg.find("nan"), std::string::npos) << which;
                     ASSERT_EQ(complaint_about_numbers(svg), "") << which;
                   });
}

TEST(Picture, AClaimMayBeMissing) {
  const Case one = read_case(R"({"query":"quadratic","a":1,"b":-3,"c":2})");
  const Answer exact = oracle::answer(one);
  EXPECT_EQ(complaint_about_xml(case_still(one, &exact, nullptr)), "");
}

TEST(Picture, AnErrorTooSmallToSeeIsMagnifiedAndLabelled) {
  const Case one = read_case(R"({"query":"quadratic","precision":"float32","a":1,"b":1000,"c":1})");
  const Answer exact = oracle::answer(one);
  const Answer claimed = find_subject("quadratic/textbook")->answer(one);
  const std::string svg = case_still(one, &exact, &claimed);
  EXPECT_NE(svg.find("Magnified"), std::string::npos);
  EXPECT_NE(svg.find("off by 7.1e-6"), std::string::npos);
}

TEST(Picture, MarkupInANoteIsText) {
  const Case one =
      read_case(R"({"query":"quadratic","a":1,"b":-3,"c":2,"note":"<script>alert(1)</script>"})");
  const std::string page = case_page({one, oracle::answer(one), "", {}, {}}, "data:,");
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
}

TEST(Page, OfACaseOpensAtTheStepThatSpoiltTheAnswer) {
  const Case one = read_case(lessons_of("far-sphere").front()->case_text);
  const Stage stage = stage_of(report_lesson(one, "sphere/textbook"));
  const std::string opens = "data-first=\"" + std::to_string(stage.decisive_step) + "\"";
  EXPECT_GT(stage.decisive_step, 0U);
  EXPECT_NE(case_page(report_lesson(one, "sphere/textbook")).find(opens), std::string::npos);
  EXPECT_NE(stage_page(stage).find("data-first=\"0\""), std::string::npos);
}

TEST(CaseFigure, HasASceneInNumbersOfEveryCase) {
  for_every_family(
      1, [](const Case& one, const Answer& exact, const Answer& claimed, const std::string& which) {
        const std::string figure = case_figure(one, &exact, &claimed);
        EXPECT_EQ(figure.find("null"), std::string::npos) << which;  // JSON's word for what is no number
      });
}

TEST(Page, IsOneFileThatNeedsNothingFromElsewhere) {
  for_every_family(1,
                   [](const Case& one, const Answer& exact, const Answer& claimed, const std::string& which) {
                     const CaseReport report{one, exact, "a/method", claimed, recorded_walk(one, "textbook")};
                     std::string page = case_page(report, "data:,");
                     for (const std::string_view none : {"src=\"data:,\"", "href=\"data:,\""})
                       page.erase(page.find(none), none.size());
                     ASSERT_EQ(complaint_about_addresses(page), "") << which;
                   });
}

TEST(Clip, ALineKeepsOnlyItsPartsInside) {
  const auto parts = clip_line({{-10, 5}, {20, 5}, {20, 30}, {5, 30}, {5, -5}}, {0, 0, 10, 10});
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].front().x, 0);
  EXPECT_EQ(parts[0].back().x, 10);
  EXPECT_EQ(parts[1].front().y, 10);
}

TEST(Clip, AnAreaAroundTheBoxBecomesTheBox) {
  EXPECT_EQ(clip_area({{-9, -9}, {99, -9}, {99, 99}, {-9, 99}}, {0, 0, 10, 10}).size(), 4U);
  EXPECT_TRUE(clip_area({{20, 20}, {30, 20}, {30, 30}}, {0, 0, 10, 10}).empty());
}

TEST(Clip, WhatIsAtNoFinitePlaceIsLeftOut) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(clip_line({{0, 0}, {infinite, 5}}, {0, 0, 10, 10}).empty());
  EXPECT_TRUE(clip_area({{0, 0}, {1, std::nan("")}, {1, 0}}, {0, 0, 10, 10}).empty());
}

}  // namespace
}  // namespace rayproof::viz
