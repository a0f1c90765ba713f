#include "bench/figures/json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "unit/bench/rows.hpp"

namespace rayproof::report {
namespace {

TEST(Json, HasTheKeysOfTheCaseFormatInEveryRow) {
  BenchRow floor{"sphere", floor_name, Precision::float64, Arrangement::batch, "random", 0.5};
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
  const BenchRow floor{"sphere", floor_name, Precision::float64, Arrangement::batch, "random", 0.5};
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

TEST(Json, HasTheCurvesWithTheSamplesOfEverySize) {
  const std::vector<BenchRow> curve{curve_row("scenes", "spheres", "list", 1, 50),
                                    curve_row("scenes", "spheres", "list", 1000, 700)};
  const Measurements read = from_json(to_json({"m", "c", 1, {}, curve}));
  ASSERT_EQ(read.scaling.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(read.scaling[i].is_same_as(curve[i]));
    EXPECT_EQ(read.scaling[i].ns_per_ray, curve[i].ns_per_ray);
    EXPECT_EQ(read.scaling[i].passes_ns.size(), 5U);
  }
}

TEST(Json, OfAnOlderReportWithoutCurvesIsRead) {
  EXPECT_TRUE(from_json(R"({"machine": "m", "compiler": "c", "rows": []})").scaling.empty());
}

TEST(Json, OfTheOracleHasATimeAndNoErrors) {
  const BenchRow oracle{"sphere", oracle_name, Precision::float32, Arrangement::scalar, "random", 150};
  const std::string text = to_json({"m", "c", 64, {oracle}});
  EXPECT_TRUE(nlohmann::json::parse(text)["rows"][0]["wrong_hits"].is_null());
  EXPECT_EQ(from_json(text).rows.at(0).ns_per_ray, 150);
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
  one["rows"][0]["wrong_hits"] = 0;
  one["rows"][0]["ns_per_ray"] = 0;
  EXPECT_EQ(complaint(one.dump()), "rows[0]: \"ns_per_ray\" can't be 0");
}

TEST(Json, WithANumberThatNoReportHasIsRefusedByTheFieldsName) {
  const auto report = nlohmann::json::parse(
      to_json({"m", "c", 1, {sphere_row("centred", Arrangement::batch, "far", 1, 0, 0)}}));
  for (const auto& [field, value] :
       std::initializer_list<std::pair<const char*, nlohmann::json>>{{"mean_bits", 1e300},
                                                                     {"mean_bits", "inf"},
                                                                     {"mean_bits", true},
                                                                     {"max_ulp", -1},
                                                                     {"p99_ulp", "-inf"},
                                                                     {"max_point", nlohmann::json::array()},
                                                                     {"wrong_hits", -1},
                                                                     {"wrong_misses", 1e300},
                                                                     {"agreed_hits", nullptr},
                                                                     {"rays", 1e300},
                                                                     {"ns_per_ray", 1e300},
                                                                     {"ns_per_ray", 1e-300},
                                                                     {"passes_ns", {1, 0}},
                                                                     {"passes_ns", {"one"}},
                                                                     {"passes_ns", 3}}) {
    auto one = report;
    one["rows"][0][field] = value;
    EXPECT_TRUE(complaint(one.dump()).starts_with("rows[0]: \"" + std::string(field) + "\" "))
        << field << " " << value << ": " << complaint(one.dump());
  }
}

TEST(Json, OfACurveThatIsNoneIsRefusedByAWordOnThePlace) {
  auto one =
      nlohmann::json::parse(to_json({"m", "c", 1, {}, {curve_row("scenes", "spheres", "list", 3, 50)}}));
  one["scaling"][0]["size"] = -3;
  EXPECT_EQ(complaint(one.dump()), "scaling[0]: \"size\" can't be -3");
  one["scaling"][0]["size"] = 1e300;
  EXPECT_EQ(complaint(one.dump()), "scaling[0]: \"size\" can't be 1e+300");
  one["scaling"][0].erase("size");
  EXPECT_EQ(complaint(one.dump()), "scaling[0]: there is no \"size\"");
  one["scaling"] = "none";
  EXPECT_EQ(complaint(one.dump()), "the report: \"scaling\" is no array");
}

}  // namespace
}  // namespace rayproof::report
