#include <cmath>
#include <nlohmann/json.hpp>

#include "case/json/number.hpp"
#include "case/writer.hpp"
#include "viz/told.hpp"

namespace rayproof::viz {
namespace {

using Json = nlohmann::ordered_json;

Json values(const std::vector<WalkValue>& list) {
  Json all = Json::array();
  for (const WalkValue& v : list) {
    all.push_back({{"name", v.name},
                   {"formula", v.formula},
                   {"value", json_number(v.value)},
                   {"exact", v.exact},
                   {"error", json_number(std::abs(v.error))},
                   {"error_bound", json_number(v.error_bound)},
                   {"bits_lost", v.bits_lost}});
  }
  return all;
}

Json steps(const Walkthrough& walk) {
  Json all = Json::array();
  for (const WalkStep& step : walk.steps) {
    Json items = Json::array();
    for (const WalkItem& item : step.items)
      items.push_back({{"label", item.label}, {"geometry", item.geometry}});
    all.push_back({{"title", step.title},
                   {"meaning", step.meaning},
                   {"caption", step.caption},
                   {"values", values(step.values)},
                   {"items", items}});
  }
  return all;
}

Json death(const Walkthrough& walk) {
  if (!walk.death) return nullptr;
  const Death& death = *walk.death;
  return {{"step", death.step},
          {"operation", death.kind},
          {"formula", death.formula},
          {"result", death.name},
          {"bits_lost_here", death.bits_lost_here},
          {"bits_lost", death.bits_lost},
          {"digits", death.digits}};
}

}  // namespace

std::string explain_json(const Told& told) {
  static constexpr const char* outcomes[] = {"faithful", "inaccurate", "flipped"};
  Json json;
  json["case"] = Json::parse(write_case(told.one));
  json["method"] = told.method;
  if (told.walk) {
    json["title"] = told.walk->title;
    json["source"] = told.walk->source;
    json["inputs"] = values(told.walk->inputs);
    json["steps"] = steps(*told.walk);
    json["outcome"] = outcomes[static_cast<std::size_t>(told.walk->outcome)];
    json["death"] = death(*told.walk);
  }
  json["exact"] = Json::parse(write_answer(told.one, told.exact));
  if (told.measured) {
    const auto& [is_wrong, margin, residual] = *told.measured;
    json["measured"] = {
        {"wrong_verdict", is_wrong}, {"margin", json_number(margin)}, {"residual", json_number(residual)}};
  }
  if (told.claimed) json["got"] = Json::parse(write_answer(told.one, *told.claimed));
  json["conclusion"] = conclusion_of(told);
  return json.dump();
}

}  // namespace rayproof::viz
