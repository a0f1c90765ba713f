/// \file
/// What a step's sentences claim (at right angles, signs, orders, equal, at most) holds of the exact numbers
/// of hundreds of random cases a topic.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "unit/viz/stage_data.hpp"
#include "viz/scene/numbers_by_name.hpp"
#include "viz/trace/shadow.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/sentences.hpp"

namespace rayproof::viz {
namespace {

/// The exact numbers known in a step, and the step's own.
struct Said {
  const CaseReport& report;
  const NumbersByName& n;
  std::size_t step;
};

bool speaks_of(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

/// `part` of both lengths: the exact numbers are rounded to double before this test sees them.
testing::AssertionResult are_perpendicular(const glm::dvec3& a, const glm::dvec3& b, double part = 1e-14) {
  const double size = glm::length(a) * glm::length(b);
  if (!std::isfinite(size) || !(size > 1e-280) || std::abs(glm::dot(a, b)) <= part * size)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << glm::dot(a, b) / size << " is the cosine";
}

testing::AssertionResult are_equal(double a, double b, double scale) {
  if (!std::isfinite(a) || !std::isfinite(b) || !std::isfinite(scale) ||
      std::abs(a - b) <= 1e-13 * std::abs(scale) + 1e-280)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << a << " is not " << b;
}

glm::dvec3 edge(const NumbersByName& n, const char* to) { return n.input(to) - n.input("a"); }

/// b² − 4ac of the ray's quadratic in t, and the scale at which doubles know it.
void expect_discriminant(const NumbersByName& n, const glm::dvec3& f, const glm::dvec3& d, double radius) {
  const double a = glm::dot(d, d), b = 2 * glm::dot(d, f), c = glm::dot(f, f) - radius * radius;
  EXPECT_TRUE(are_equal(b * b - 4 * a * c, 4 * a * n["D"], b * b + 4 * a * (std::abs(c) + radius * radius)));
}

bool is_sphere(const NumbersByName& n) { return n.has_vector("C"); }

/// In the scaled plane of a cylinder f, d and l have no z.
glm::dvec3 plane_of(const NumbersByName& n, const char* name) {
  const bool is_unit = std::string(name) == "d" && n.has_vector("d̂");  // what that kernel calls its d
  glm::dvec3 v = n.vector(is_unit ? "d̂" : name);
  if (!is_sphere(n)) v.z = 0;
  return v;
}

double radius_of(const NumbersByName& n) { return is_sphere(n) ? n["r"] : 1; }

/// A claim by words of its sentence, and its check.
struct CheckedClaim {
  const char* words;
  std::function<void(const Said& said)> check;
};

const std::vector<CheckedClaim>& claims() {
  static const std::vector<CheckedClaim> all{
      {"p = d × e₂ is perpendicular to the ray and to e₂",
       [](const Said& s) {
         EXPECT_TRUE(are_perpendicular(s.n.vector("p"), s.n.direction()));
         EXPECT_TRUE(are_perpendicular(s.n.vector("p"), s.n.vector("e₂")));
       }},
      {"q is perpendicular to s and e₁",
       [](const Said& s) {
         EXPECT_TRUE(are_perpendicular(s.n.vector("q"), s.n.vector("s")));
         EXPECT_TRUE(are_perpendicular(s.n.vector("q"), s.n.vector("e₁")));
       }},
      {"n is perpendicular to both edges",
       [](const Said& s) {
         EXPECT_TRUE(are_perpendicular(s.n.vector("n"), edge(s.n, "b"), 1e-13));
         EXPECT_TRUE(are_perpendicular(s.n.vector("n"), edge(s.n, "c"), 1e-13));
       }},
      {"they are perpendicular to its normal and to each other",
       [](const Said& s) {
         EXPECT_TRUE(are_perpendicular(s.n.vector("u"), s.n.vector("n")));
         EXPECT_TRUE(are_perpendicular(s.n.vector("v"), s.n.vector("n")));
         EXPECT_TRUE(are_perpendicular(s.n.vector("u"), s.n.vector("v")));
       }},
      {"is perpendicular to d",  // l of a sphere and of a cylinder
       [](const Said& s) { EXPECT_TRUE(are_perpendicular(plane_of(s.n, "l"), plane_of(s.n, "d"), 1e-13)); }},
      {"Where the line passes within the radius, D is positive",
       [](const Said& s) {
         const double l = glm::length(plane_of(s.n, "l")), r = radius_of(s.n);
         if (std::abs(l - r) > 1e-13 * (l + r)) {
           EXPECT_EQ(s.n["D"] > 0, l < r);
         }
       }},
      {"b² − 4ac of the quadratic formula is 4a·D",
       [](const Said& s) {
         expect_discriminant(s.n, plane_of(s.n, "f"), plane_of(s.n, "d"), radius_of(s.n));
       }},
      {"the line meets the surface h before and h after t_c",
       [](const Said& s) {
         if (!(s.n["D"] > 0)) return;
         const double h = s.n["h"], t = s.n["t_c"];
         const glm::dvec3 f = plane_of(s.n, "f"), d = plane_of(s.n, "d");
         const double scale = std::pow(glm::length(f) + std::abs(t + h) * glm::length(d), 2);
         for (const double hit : {t - h, t + h}) {
           const glm::dvec3 p = f + hit * d;
           EXPECT_TRUE(are_equal(glm::dot(p, p), radius_of(s.n) * radius_of(s.n), scale));
         }
       }},
      {"S_x and S_y are at most 1 in size",
       [](const Said& s) {
         for (const char* name : {"S_x", "S_y"}) {
           EXPECT_LE(std::abs(s.n[name]), 1);
           EXPECT_LE(std::abs(s.n.rounded(name)), 1);
         }
       }},
      {"The sign of U, V and W is exact",
       [](const Said& s) {
         // Of the corners as they were rounded.
         const auto sign_of = [&](const char* name, const char* x, const char* y) {
           const auto at = [&](const char* corner, const char* axis) {
             return Shadow(s.n.rounded(std::string(corner) + axis));
           };
           const Shadow exact = at(x, ".x") * at(y, ".y") - at(x, ".y") * at(y, ".x");
           const double rounded = s.n.rounded(name);
           const bool underflows =
               abs(at(x, ".x") * at(y, ".y")) < 1e-30 || abs(at(x, ".y") * at(y, ".x")) < 1e-30;
           if (std::isfinite(rounded) && isfinite(exact) && !underflows) {
             EXPECT_EQ(exact > 0, rounded > 0) << name;
             EXPECT_EQ(exact < 0, rounded < 0) << name;
           }
         };
         sign_of("U", "c", "b");
         sign_of("V", "a", "c");
         sign_of("W", "b", "a");
       }},
      {"D = e₁·(d × e₂) is the volume",
       [](const Said& s) {
         const glm::dvec3 e1 = s.n.vector("e₁"), e2 = s.n.vector("e₂"), d = s.n.direction();
         EXPECT_TRUE(are_equal(s.n["D"], glm::dot(e1, glm::cross(d, e2)),
                               glm::length(e1) * glm::length(e2) * glm::length(d)));
       }},
      {"D is the signed volume that u, v and d span",
       [](const Said& s) {
         const glm::dvec3 u = s.n.vector("u"), v = s.n.vector("v"), d = s.n.direction();
         EXPECT_TRUE(are_equal(s.n["D"], glm::dot(glm::cross(u, v), d),
                               glm::length(u) * glm::length(v) * glm::length(d)));
       }},
      {"each unknown is a quotient of two volumes",
       [](const Said& s) {  // α·u + β·v − t·d = w
         if (s.n["D"] == 0) return;
         const glm::dvec3 u = s.n.vector("u"), v = s.n.vector("v"), w = s.n.vector("w"), d = s.n.direction();
         const double t = s.n["t"], alpha = s.n["α"], beta = s.n["β"];
         const glm::dvec3 sum = alpha * u + beta * v - t * d - w;
         const double scale = std::abs(alpha) * glm::length(u) + std::abs(beta) * glm::length(v) +
                              std::abs(t) * glm::length(d) + glm::length(w);
         EXPECT_TRUE(are_equal(glm::length(sum), 0, scale));
       }},
      {"In real numbers all three n·e are the volume of the solid",
       [](const Said& s) {
         const double size = std::abs(s.n["n₀·e₀"]);
         EXPECT_TRUE(are_equal(s.n["n₀·e₀"], s.n["n₁·e₁"], size));
         EXPECT_TRUE(are_equal(s.n["n₀·e₀"], s.n["n₂·e₂"], size));
       }},
      {"each n·e is the volume of the solid",
       [](const Said& s) {
         const glm::dvec3 volume = s.n.vector("n·e");
         EXPECT_TRUE(are_equal(volume.x, volume.y, volume.x));
         EXPECT_TRUE(are_equal(volume.x, volume.z, volume.x));
       }},
      {"two numbers of one sign cannot cancel",
       [](const Said& s) {
         if (s.report.method != "quadratic/full_range" && s.n.has("q") && s.n.has("b") &&
             std::isfinite(s.n["q"]) && s.n["b"] != 0) {
           EXPECT_GE(2 * std::abs(s.n["q"]), (1 - 1e-15) * std::abs(s.n["b"]));
         }
       }},
      {"one for D = 0, none for D < 0",
       [](const Said& s) {
         if (!s.n.has("a") || s.n["a"] == 0 || !std::isfinite(s.n["D"])) return;
         const double scale = s.n["b"] * s.n["b"] + std::abs(4 * s.n["a"] * s.n["c"]);
         EXPECT_TRUE(are_equal(s.n["D"], s.n["b"] * s.n["b"] - 4 * s.n["a"] * s.n["c"], scale));
       }},
      {"where D < 0, √D is NaN: no real root",
       [](const Said& s) {
         const double D = s.n.rounded("D");
         EXPECT_EQ(std::isnan(s.n.rounded("√D")), D < 0 || std::isnan(D)) << D;
       }},
      {"f points from the centre to o",
       [](const Said& s) {
         const glm::dvec3 f = s.n.origin() - s.n.vector("C");
         EXPECT_TRUE(are_equal(glm::length(f - s.n.vector("f")), 0,
                               glm::length(s.n.origin()) + glm::length(s.n.vector("C"))));
       }},
      {"n·(p - o) is its distance from o along n, times |n|",
       [](const Said& s) {
         if (!s.n.has_vector("p") || !s.n.has_vector("n")) return;
         const glm::dvec3 n = s.n.vector("n"), way = s.n.vector("p") - s.n.origin();
         EXPECT_TRUE(are_equal(s.n["n·(p - o)"], glm::dot(n, way),
                               glm::length(n) * (glm::length(s.n.vector("p")) + glm::length(s.n.origin()))));
       }},
      {"from the largest entry to the smallest exit",
       [](const Said& s) {
         if (s.n.has("e₀") && std::isfinite(s.n["t_entry"])) {
           EXPECT_LE(s.n["e₀"], s.n["t_entry"]);
         }
         if (s.n.has("e₁") && std::isfinite(s.n["t_exit"])) {
           EXPECT_GE(s.n["e₁"], s.n["t_exit"]);
         }
       }},
      {"leads from a to b", [](const Said& s) {
         const glm::dvec3 e = s.n.vector(s.n.has_vector("e₁") ? "e₁" : "u");
         EXPECT_TRUE(are_equal(glm::length(e - edge(s.n, "b")), 0,
                               glm::length(s.n.input("a")) + glm::length(s.n.input("b"))));
       }}};
  return all;
}

/// Every method that can be recorded, on random cases of every family.
void for_recorded_cases(std::uint64_t seeds, const std::function<void(const CaseReport&)>& check) {
  for (const Family& family : families()) {
    for (const Subject& subject : subjects()) {
      if (subject.topic != family.topic) continue;
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        for (const Precision precision : {Precision::float32, Precision::float64}) {
          const CaseReport report = report_of(family.generate(1000 + seed, precision), &subject);
          if (!report.walk) break;
          check(report);
        }
      }
    }
  }
}

TEST(TrueCaptions, WhatASentenceClaimsHoldsOfTheExactNumbers) {
  std::map<std::string, std::size_t> checked;
  std::map<std::string, std::set<std::string>> cases;
  for_recorded_cases(6, [&](const CaseReport& report) {
    cases[topic_of(report.one)].insert(write_case(report.one));
    for (std::size_t i = 0; i < report.walk->steps.size(); ++i) {
      const NumbersByName n(*report.walk, i);
      for (const CheckedClaim& claim : claims()) {
        if (!speaks_of(report.walk->steps[i].meaning, claim.words)) continue;
        SCOPED_TRACE(report.method + ": " + claim.words + "\n" + write_case(report.one));
        ++checked[claim.words];
        claim.check({report, n, i});
      }
    }
  });
  for (const CheckedClaim& claim : claims()) EXPECT_GT(checked[claim.words], 50U) << claim.words;
}

/// A word that claims something of the case's numbers, which a test must hold a sentence to.
TEST(TrueCaptions, NoSentenceClaimsWithoutACheck) {
  std::set<std::string> unchecked;
  for_recorded_cases(1, [&](const CaseReport& report) {
    for (const WalkStep& step : report.walk->steps) {
      for (const std::string& sentence : sentences_of(step.meaning)) {
        const bool claims_something =
            speaks_of(sentence, "is perpendicular to") || speaks_of(sentence, "are perpendicular to") ||
            speaks_of(sentence, "is positive") || speaks_of(sentence, "at most 1 in") ||
            speaks_of(sentence, "cannot cancel") || speaks_of(sentence, "is exact where") ||
            speaks_of(sentence, "are the volume") || speaks_of(sentence, "is the volume");
        const bool is_checked = std::any_of(claims().begin(), claims().end(), [&](const CheckedClaim& c) {
          return speaks_of(sentence, c.words);
        });
        if (claims_something && !is_checked) unchecked.insert(report.method + ": " + sentence);
      }
    }
  });
  for (const std::string& sentence : unchecked) ADD_FAILURE() << sentence;
}

/// Of a lesson's own case: what its captions say of signs and sizes.
TEST(TrueCaptions, ALessonsOwnNumbersAreThoseOfItsCase) {
  const auto numbers_of = [](const char* lesson) {
    const Lesson& one = *lessons_of(lesson).front();
    return report_lesson(read_case(one.case_text), one.method);
  };
  const CaseReport far = numbers_of("far-sphere");
  const NumbersByName n(*far.walk, far.walk->steps.size() - 1);
  const auto b = static_cast<float>(n.rounded("b")), a = static_cast<float>(n.rounded("a")),
             c = static_cast<float>(n.rounded("c"));
  EXPECT_EQ(b * b, 6560707584.0F);
  EXPECT_EQ(4 * a * c, 6560708608.0F);
  EXPECT_EQ(std::nextafter(6560707584.0F, 7e9F) - 6560707584.0F, 512.0F);

  const CaseReport padded = numbers_of("conservative");
  const NumbersByName p(*padded.walk, padded.walk->steps.size() - 1);
  EXPECT_LT(p["t_exit"], p["t_entry"]);
  EXPECT_LT(p.rounded("t_exit"), p.rounded("t_entry"));
  EXPECT_GE(p.rounded("t_padded"), p.rounded("t_entry"));
}

TEST(TrueCaptions, EveryShrunkCaseOfThePropertyTestStillDisagrees) {
  const Stage stage = stage_of(*lessons_of("property-test").front(), report_lesson);
  EXPECT_TRUE(speaks_of(stage.steps.at(0).caption, "They agree."));
  for (std::size_t i = 1; i < 5; ++i) EXPECT_TRUE(speaks_of(stage.steps.at(i).caption, "They differ.")) << i;
}

TEST(TrueCaptions, OnlyAStartBelowTheSurfaceMeetsItAgain) {
  const Stage stage = stage_of(*lessons_of("acne").front(), report_lesson);
  std::size_t acne = 0;
  for (const StageStep& step : stage.steps) {
    if (!step.title.starts_with("Start by")) continue;
    const bool is_below = speaks_of(step.caption, "below the surface");
    EXPECT_EQ(speaks_of(step.caption, "acne"), is_below) << step.caption;
    acne += is_below ? 1 : 0;
  }
  EXPECT_EQ(acne, 2U);  // no offset, and one that is less than the rounding
}

}  // namespace
}  // namespace rayproof::viz
