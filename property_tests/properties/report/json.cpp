#include "case/json/ordered.hpp"
#include "properties/report/report.hpp"

namespace rayproof {

namespace {

using Json = nlohmann::ordered_json;

Json bound(double measured, double promised) {
  return {{"measured", json_number(measured)}, {"promised", json_number(promised)}};
}

Json worst_errors(const Worst& worst, const Contract& contract) {
  Json json{{"verdict", bound(worst.verdict, contract.verdict.promised)},
            {"residual", bound(worst.residual, contract.residual.promised)},
            {"ulp", bound(worst.ulp, contract.ulp.promised)}};
  if (worst.details > 0) {
    json["point"] = bound(worst.point, contract.hit.point.promised);
    json["normal"] = bound(worst.normal, contract.hit.normal.promised);
    json["coordinates"] = bound(worst.coordinates, contract.hit.coordinates.promised);
  }
  json["wrong_verdicts"] = worst.wrong;
  json["cases_in_domain"] = worst.cases;
  return json;
}

Json json_of(const Row& row) {
  Json statuses = Json::array();
  for (const Cell& cell : row.cells)
    if (cell.status != ClaimStatus::unclaimed)
      statuses.push_back({{"property", cell.property->name},
                          {"mark", text_of(cell.status).words},
                          {"held", cell.tally.held},
                          {"broken", cell.tally.broken},
                          {"outside", cell.tally.outside}});
  Json json{
      {"method", row.subject->full_name()}, {"precision", name_of(row.precision)}, {"cases", row.cases}};
  if (row.is_measured()) json["worst"] = worst_errors(row.worst, row.subject->contract);
  json["properties"] = std::move(statuses);
  return json;
}

Json json_of(const Unit& unit) {
  return {{"method", unit.subject->full_name()},
          {"precision", name_of(unit.precision)},
          {"family", unit.family->name},
          {"cases", unit.tally.cases},
          {"worst", worst_errors(unit.tally.worst, unit.subject->contract)}};
}

Json json_of(const LabelCount& labels) {
  Json shares = Json::object();
  for (const auto& [label, count] : labels.counts) shares[label] = labels.share(label);
  return {{"topic", labels.family->topic},
          {"family", labels.family->name},
          {"precision", name_of(labels.precision)},
          {"cases", labels.cases},
          {"shares", std::move(shares)}};
}

Json json_of(const Finding& finding) { return read_json(write_finding(finding)); }

template <class Item>
Json array_of(const std::vector<Item>& items) {
  Json array = Json::array();
  for (const Item& item : items) array.push_back(json_of(item));
  return array;
}

}  // namespace

std::string json_report(const Plan& plan, const RunResult& result, const Summary& summary) {
  const Json json{{"seed", plan.settings.seed},
                  {"cases", plan.settings.cases},
                  {"corpus_cases", result.corpus_cases},
                  {"success", summary.is_success()},
                  {"interrupted", summary.was_interrupted},
                  {"failures", summary.failures()},
                  {"methods", array_of(summary.rows)},
                  {"families", array_of(result.units)},
                  {"labels", array_of(result.labels)},
                  {"findings", array_of(result.findings)}};
  return write_json(json, 2);
}

}  // namespace rayproof
