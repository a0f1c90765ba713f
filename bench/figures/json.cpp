#include "bench/figures/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bench/figures/json_fields.hpp"
#include "case/json/ordered.hpp"

namespace rayproof::report {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array errors_by_name{
    std::pair{"max_ulp", &Accuracy::max_ulp},       std::pair{"p99_ulp", &Accuracy::p99_ulp},
    std::pair{"mean_bits", &Accuracy::mean_bits},   std::pair{"max_point", &Accuracy::max_point},
    std::pair{"max_normal", &Accuracy::max_normal}, std::pair{"max_coordinates", &Accuracy::max_coordinates}};

/// JSON has neither infinity nor NaN: the case format's string for the one, null for what there is none of.
Json number(double x) {
  if (std::isnan(x)) return nullptr;
  if (std::isinf(x)) return "inf";
  return x;
}

/// Four digits: no pass is timed to more.
Json passes_of(const std::vector<double>& passes_ns) {
  Json json = Json::array();
  for (const double ns : passes_ns) json.push_back(std::stod(fmt::format("{:.4g}", ns)));
  return json;
}

Json row_of(const BenchRow& row, std::size_t timed_rays) {
  Json json{{"shape", row.shape},
            {"method", row.method},
            {"precision", name_of(row.precision)},
            {"arrangement", name_of(row.arrangement)},
            {"family", row.family},
            {"rays", row.has_errors() ? row.accuracy.cases : timed_rays},
            {"ns_per_ray", row.ns_per_ray},
            {"passes_ns", passes_of(row.passes_ns)}};
  const Accuracy& errors = row.accuracy;
  const auto add = [&](const char* name, const Json& value) {
    json[name] = row.has_errors() ? value : Json();
  };
  add("wrong_hits", errors.wrong_hits);
  add("wrong_misses", errors.wrong_misses);
  add("agreed_hits", errors.agreed_hits);
  for (const auto& [name, error] : errors_by_name) add(name, number(errors.*error));
  return json;
}

/// What stands at one size of a curve.
Json scaling_of(const BenchRow& row) {
  return {{"curve", row.family},
          {"shape", row.shape},
          {"method", row.method},
          {"precision", name_of(row.precision)},
          {"arrangement", name_of(row.arrangement)},
          {"size", row.size},
          {"ns_per_ray", row.ns_per_ray},
          {"passes_ns", passes_of(row.passes_ns)}};
}

/// What a row and a curve's have in common; the key `family_name` has the family.
BenchRow read_timed(const Json& json, const std::string& place, const char* family_name) {
  BenchRow row{member<std::string>(json, place, "shape"),
               member<std::string>(json, place, "method"),
               named_in(json, place, "precision", {Precision::float32, Precision::float64}),
               named_in(json, place, "arrangement", {Arrangement::scalar, Arrangement::batch}),
               member<std::string>(json, place, family_name),
               time_in(json, place, "ns_per_ray")};
  row.passes_ns = times_in(json, place, "passes_ns");
  return row;
}

BenchRow read_row(const Json& json, const std::string& place) {
  BenchRow row = read_timed(json, place, "family");
  if (!row.has_errors()) return row;
  row.accuracy.cases = count_in(json, place, "rays");
  row.accuracy.wrong_hits = count_in(json, place, "wrong_hits");
  row.accuracy.wrong_misses = count_in(json, place, "wrong_misses");
  row.accuracy.agreed_hits = count_in(json, place, "agreed_hits");
  for (const auto& [name, error] : errors_by_name) row.accuracy.*error = error_in(json, place, name);
  return row;
}

BenchRow read_scaling(const Json& json, const std::string& place) {
  BenchRow row = read_timed(json, place, "curve");
  row.size = count_in(json, place, "size", 1e-6);
  return row;
}

/// The elements of an array, each read by `read(element, place)`.
std::vector<BenchRow> rows_in(const Json& json, const char* name,
                              BenchRow (*read)(const Json&, const std::string&)) {
  const Json all = member<Json>(json, "the report", name);
  if (!all.is_array()) throw FiguresError(fmt::format("the report: \"{}\" is no array", name));
  std::vector<BenchRow> rows;
  for (std::size_t i = 0; i < all.size(); ++i) rows.push_back(read(all[i], fmt::format("{}[{}]", name, i)));
  return rows;
}

}  // namespace

std::string to_json(const Measurements& figures) {
  Json rows = Json::array();
  for (const BenchRow& row : figures.rows) rows.push_back(row_of(row, figures.rays));
  Json scaling = Json::array();
  for (const BenchRow& row : figures.scaling) scaling.push_back(scaling_of(row));
  return write_json({{"machine", figures.machine},
                     {"compiler", figures.compiler},
                     {"rows", std::move(rows)},
                     {"scaling", std::move(scaling)}},
                    1);
}

Measurements from_json(const std::string& text) {
  const Json json = read_json(text, false);
  if (json.is_discarded()) throw FiguresError("this is not JSON");
  Measurements figures{member<std::string>(json, "the report", "machine"),
                       member<std::string>(json, "the report", "compiler"), 0,
                       rows_in(json, "rows", read_row)};
  for (std::size_t i = 0; i < json["rows"].size(); ++i) {
    const Json& row = json["rows"][i];
    if (row.contains("rays"))
      figures.rays = std::max(figures.rays, count_in(row, fmt::format("rows[{}]", i), "rays"));
  }
  // Older reports have no curves.
  if (json.contains("scaling")) figures.scaling = rows_in(json, "scaling", read_scaling);
  return figures;
}

}  // namespace rayproof::report
