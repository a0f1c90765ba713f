#include "bench/figures/json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "unit/bench/rows.hpp"

namespace rayproof::report {
namespace {

TEST(Json, HasTheKeysOfTheCaseFormatInEveryRow) {
  BenchRow floor{"sphere", BenchRow::floor_name, Precision::float64, Arrangement::batch, "random", 0.5};
  const auto json = nlohmann::json::parse(to_json(
      {"machine", "compiler", 64, {sphere_row("centred", Arrangement::scalar, "random", 1, 2, 3), floor}}));
  EXPECT_EQ(json.at("machine"), "machine");
  for (const auto& one : json.at("rows")) {
    for (const char* key : {"shape", "method", "precision", "arrangement", "family", "rays", "ns_per_ray",
                            "wrong_hits", "wrong_misses", "passes_ns", "agreed_hits", "max_ulp", "p99_ulp",
                            "mean_bits", "max_point", "max_normal", "max_coordinates"})
      EXPECT_TRUE(one.contains(key)) << key;
  }
  EXPECT_EQ(json["rows"][0]["wrong_misses"], 2);
  EXPECT_TRUE(json["rows"][1]["max_ulp"].is_null());
}

TEST(Json, IsReadAsItWasWritten) {
  BenchRow one = sphere_row("centred", Arrangement::batch, "far", 1.25, 3, 0.5);
  one.passes_ns = {1.25, 1.5, 1};
  one.accuracy.max_ulp = std::numeric_limits<double>::infinity();
  one.accuracy.max_coordinates = std::numeric_limits<double>::quiet_NaN();
  const BenchRow floor{"sphere", BenchRow::floor_name, Precision::float64, Arrangement::batch, "random", 0.5};
  const Measurements read = from_json(to_json({"some machine", "some compiler", 1000, {one, floor}}));
  EXPECT_EQ(read.machine, "some machine");
  EXPECT_EQ(read.compiler, "some compiler");
  EXPECT_EQ(read.rays, 1000U);
  ASSERT_EQ(read.rows.size(), 2U);
  EXPECT_TRUE(read.rows[0].is_same_as(one));
  EXPECT_TRUE(read.rows[1].is_same_as(floor));
  EXPECT_EQ(read.rows[0].ns_per_ray, 1.25);
  EXPECT_EQ(read.rows[0].passes_ns, one.passes_ns);
  EXPECT_EQ(read.rows[0].accuracy.cases, 1000U);
  EXPECT_EQ(read.rows[0].accuracy.wrong_misses, 3U);
  EXPECT_EQ(read.rows[0].accuracy.agreed_hits, 100U);
  EXPECT_EQ(read.rows[0].accuracy.max_ulp, std::numeric_limits<double>::infinity());
  EXPECT_EQ(read.rows[0].accuracy.mean_bits, 0.5);
  EXPECT_TRUE(std::isnan(read.rows[0].accuracy.max_coordinates));
}

/// What from_json says of a text.
std::string complaint(const std::string& text) {
  try {
    (void)from_json(text);
  } catch (const FiguresError& trouble) {
    return trouble.what();
  }
  return "nothing";
}

TEST(Json, ThatIsNoReportIsRefusedByAWordOnThePlace) {
  EXPECT_EQ(complaint("{"), "this is not JSON");
  EXPECT_EQ(complaint("[]"), "the report: there is no \"machine\"");
  EXPECT_EQ(complaint(R"({"machine": "m", "compiler": "c"})"), "the report: there is no \"rows\"");
  EXPECT_EQ(complaint(R"({"machine": "m", "compiler": 1, "rows": []})"),
            "the report: \"compiler\" is something else than it should be");
  EXPECT_EQ(complaint(R"({"machine": "m", "compiler": "c", "rows": 3})"), "the report: \"rows\" is no array");
  EXPECT_EQ(complaint(R"({"machine": "m", "compiler": "c", "rows": [{"shape": "box"}]})"),
            "rows[0]: there is no \"method\"");
  auto one = nlohmann::json::parse(
      to_json({"m", "c", 1, {sphere_row("centred", Arrangement::batch, "far", 1, 0, 0)}}));
  one["rows"][0]["precision"] = "half";
  EXPECT_EQ(complaint(one.dump()), "rows[0]: \"precision\" can't be 'half'");
  one["rows"][0]["precision"] = "float32";
  one["rows"][0]["wrong_hits"] = "many";
  EXPECT_EQ(complaint(one.dump()), "rows[0]: \"wrong_hits\" is something else than it should be");
}

}  // namespace
}  // namespace rayproof::report
