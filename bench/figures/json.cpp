#include "bench/figures/json.hpp"

#include <cmath>

#include "case/json/ordered.hpp"

namespace rayproof::report {

namespace {

using Json = nlohmann::ordered_json;

/// JSON has neither infinity nor NaN: the case format's string for the one, null for what there is none of.
Json number(double x) {
  if (std::isnan(x)) return nullptr;
  if (std::isinf(x)) return "inf";
  return x;
}

Json row_of(const BenchRow& row, std::size_t timed_rays) {
  Json json{{"shape", row.shape},
            {"method", row.method},
            {"precision", name_of(row.precision)},
            {"arrangement", name_of(row.arrangement)},
            {"family", row.family},
            {"rays", row.is_floor() ? timed_rays : row.accuracy.cases},
            {"ns_per_ray", row.ns_per_ray}};
  const Accuracy& errors = row.accuracy;
  const auto add = [&](const char* name, const Json& value) { json[name] = row.is_floor() ? Json() : value; };
  add("wrong_hits", errors.wrong_hits);
  add("wrong_misses", errors.wrong_misses);
  add("max_ulp", number(errors.max_ulp));
  add("p99_ulp", number(errors.p99_ulp));
  add("mean_bits", number(errors.mean_bits));
  add("max_point", number(errors.max_point));
  add("max_normal", number(errors.max_normal));
  add("max_coordinates", number(errors.max_coordinates));
  return json;
}

}  // namespace

std::string to_json(const Measurements& figures) {
  Json rows = Json::array();
  for (const BenchRow& row : figures.rows) rows.push_back(row_of(row, figures.rays));
  return write_json({{"machine", figures.machine}, {"compiler", figures.compiler}, {"rows", std::move(rows)}},
                    1);
}

}  // namespace rayproof::report
