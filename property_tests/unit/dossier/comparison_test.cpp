#include "dossier/comparison.hpp"

#include <gtest/gtest.h>

namespace rayproof::dossier {
namespace {

/// A library that was asked from the origin along z, and said this.
Reproduction library_that(NamedNumbers said) {
  Reproduction made;
  made.inputs = {{"origin", {0, 0, 0}}, {"direction", {0, 0, 2}}};
  made.has_returned = true;
  made.said = std::move(said);
  return made;
}

HandCalculation hit_at(double t, const char* text) {
  HandCalculation right;
  right.hits = {t};
  right.hits_as_text = {text};
  return right;
}

TEST(AComparison, NamesAMiss) {
  const auto made =
      compare(hit_at(0.5, "0.5"), library_that({{"hit", {0}}, {"t", {0}}}), "box", Precision::float64);
  EXPECT_TRUE(made.is_wrong);
  EXPECT_EQ(made.deed, "misses a box that is hit at t = 0.5");
}

TEST(AComparison, MeasuresByWhatTheLibraryMeasuresBy) {
  const auto made = compare(hit_at(0.5, "0.5"), library_that({{"hit", {1}}, {"depth", {1.5}}}), "plane",
                            Precision::float64);
  EXPECT_TRUE(made.is_wrong);
  EXPECT_EQ(made.deed, "gives depth = 1.5 for a hit at depth ≈ 1");
}

TEST(AComparison, GivesATitleAsManyDigitsAsDistinguishTheNumbers) {
  const auto deed_of = [](double exact, const char* text, double given) {
    return compare(hit_at(exact, text), library_that({{"hit", {1}}, {"t", {given}}}), "sphere",
                   Precision::float64)
        .deed;
  };
  EXPECT_EQ(deed_of(400.0002499980468, "≈ 400.0002499980468", 400.00024996894354),
            "gives t ≈ 400.00024997 for a hit at t ≈ 400.00025");
  EXPECT_EQ(deed_of(1.0 / 4096, "1/4096", 0.00024415552616119385),
            "gives t ≈ 0.000244156 for a hit at t = 1/4096");
}

TEST(AComparison, ForgivesRounding) {
  EXPECT_FALSE(compare(hit_at(1.0 / 3, "1/3"),
                       library_that({{"hit", {1}}, {"t", {static_cast<double>(1.0F / 3)}}}), "box",
                       Precision::float32)
                   .is_wrong);
}

TEST(AComparison, SaysThatNothingCameBack) {
  Reproduction silent = library_that({});
  silent.has_returned = false;
  silent.ending = "did not return";
  EXPECT_EQ(compare(hit_at(1, "1"), silent, "sphere", Precision::float64).deed,
            "does not return, asked for a sphere");
}

TEST(AComparison, LeavesTheBoundaryToWhoeverKnowsNoBoundary) {
  HandCalculation right;
  right.is_position = right.is_on_boundary = true;
  EXPECT_FALSE(
      compare(right, library_that({{"inside", {0}}}), "point_in_polygon", Precision::float64).is_wrong);
  EXPECT_TRUE(compare(right, library_that({{"within", {1}}, {"covered_by", {1}}}), "point_in_polygon",
                      Precision::float64)
                  .is_wrong);
}

}  // namespace
}  // namespace rayproof::dossier
