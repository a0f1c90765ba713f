#include <cmath>

#include "case/json/ordered.hpp"
#include "case/writer.hpp"
#include "viz/explain/case_report.hpp"

namespace rayproof::viz {
namespace {

using Json = nlohmann::ordered_json;

Json values(const std::vector<WalkValue>& list) {
  return json_list(list, [](const WalkValue& v) {
    return Json{{"name", v.name},
                {"formula", text_of(v.formula)},
                {"value", json_number(v.value)},
                {"exact", v.exact},
                {"error", json_number(std::abs(v.error))},
                {"error_bound", json_number(v.error_bound)},
                {"bits_lost", v.bits_lost}};
  });
}

Json steps(const Walkthrough& walk) {
  return json_list(walk.steps, [](const WalkStep& step) {
    return Json{{"title", step.title},
                {"meaning", step.meaning},
                {"caption", step.caption},
                {"values", values(step.values)}};
  });
}

Json decisive_loss(const Walkthrough& walk) {
  if (!walk.decisive_loss) return nullptr;
  const PrecisionLoss& loss = *walk.decisive_loss;
  return {{"step", loss.step},
          {"operation", loss.kind},
          {"formula", loss.formula},
          {"result", loss.name},
          {"bits_lost_here", loss.bits_lost_here},
          {"bits_lost", loss.bits_lost},
          {"digits", loss.digits}};
}

}  // namespace

std::string explain_json(const CaseReport& report) {
  static constexpr const char* outcomes[] = {"faithful", "inaccurate", "flipped"};
  Json json;
  json["case"] = read_json(write_case(report.one));
  json["method"] = report.method;
  if (report.walk) {
    json["title"] = report.walk->title;
    json["source"] = report.walk->source;
    json["inputs"] = values(report.walk->inputs);
    json["steps"] = steps(*report.walk);
    json["outcome"] = outcomes[static_cast<std::size_t>(report.walk->outcome)];
    json["decisive_loss"] = decisive_loss(*report.walk);
  }
  json["exact"] = read_json(write_answer(report.one, report.exact));
  if (report.measured) {
    const auto& [is_wrong, margin, residual] = *report.measured;
    json["measured"] = {
        {"wrong_verdict", is_wrong}, {"margin", json_number(margin)}, {"residual", json_number(residual)}};
  }
  if (report.claimed) json["got"] = read_json(write_answer(report.one, *report.claimed));
  json["conclusion"] = conclusion_of(report);
  return write_json(json);
}

}  // namespace rayproof::viz
