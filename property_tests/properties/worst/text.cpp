#include <fmt/format.h>

#include <cmath>

#include "case/json/ordered.hpp"
#include "case/writer.hpp"
#include "properties/report/summary.hpp"
#include "properties/worst/search.hpp"

namespace rayproof::worst {

namespace {

using Json = nlohmann::ordered_json;

std::string promise_in_words(const WorstRow& row) {
  if (!std::isfinite(row.promised())) return "-";
  return figure(row.promised()) + (row.is_proven() ? "*" : "");
}

/// How much worse the guided search's case is; nothing where that is no number.
std::string factor_in_words(double found, double drawn) {
  const double factor = found / drawn;
  if (!std::isfinite(factor)) return "-";
  return factor < 1000 ? fmt::format("{:.3g}", factor) : fmt::format("{:.1e}", factor);
}

Json finite_or_text(double x) { return std::isfinite(x) ? Json(x) : Json(x > 0 ? "inf" : "nan"); }

}  // namespace

std::string text_table(const WorstResult& result) {
  const bool is_compared = result.drawn > 0;
  std::string text = fmt::format("{:<27} {:<8} {:<22} ", "method", "", "error");
  if (is_compared) text += fmt::format("{:>9} {:>8} ", "draws", "times");
  text += fmt::format("{:>11} {:>9}  {}\n", "worst found", "promised", "from family");
  for (const WorstRow& row : result.rows) {
    const double found = row.found ? row.found->error : 0;
    text += fmt::format("{:<27} {:<8} {:<22} ", row.subject->full_name(), name_of(row.precision),
                        row.error_name());
    if (is_compared)
      text += fmt::format("{:>9} {:>8} ", figure(row.drawn.value_or(0)),
                          factor_in_words(found, row.drawn.value_or(0)));
    text += fmt::format("{:>11} {:>9}  {}{}\n", figure(found), promise_in_words(row),
                        row.found ? row.found->family->name : "", row.exceeding ? "  EXCEEDED" : "");
  }
  return text;
}

std::string text_exceeded(const WorstResult& result) {
  std::string text;
  for (const WorstRow& row : result.rows)
    if (row.exceeding)
      text += fmt::format("EXCEEDED: {} {} promises {} of {}, and is off by {}: {}\n",
                          row.subject->full_name(), name_of(row.precision), promise_in_words(row),
                          row.error_name(), figure(row.exceeding->error), write_case(row.exceeding->one));
  return text;
}

std::string json_text(const WorstSearch& what, const WorstResult& result) {
  Json rows = Json::array();
  for (const WorstRow& row : result.rows) {
    Json one{{"method", row.subject->full_name()},
             {"precision", name_of(row.precision)},
             {"error", measure_of(row.kind).name},
             {"transformed", is_of_transformed(row.kind)},
             {"worst_found", finite_or_text(row.found ? row.found->error : 0)}};
    if (row.drawn) one["drawn"] = finite_or_text(*row.drawn);
    one["promised"] = std::isfinite(row.promised()) ? Json(row.promised()) : Json();
    one["proven"] = row.is_proven();
    one["exceeded"] = row.exceeding.has_value();
    if (row.found) one["case"] = read_json(write_case(row.found->one));
    rows.push_back(std::move(one));
  }
  const Json all{
      {"seed", what.plan.seed}, {"climbed", result.climbed}, {"drawn", result.drawn}, {"rows", rows}};
  return write_json(all, 1) + "\n";
}

}  // namespace rayproof::worst
