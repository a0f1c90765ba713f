#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/json/ordered.hpp"
#include "case/writer.hpp"
#include "viz/explain/case_report.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

/// Characters on a terminal; every one of ours is one column wide, but the arrow and the hat over a letter,
/// which have no width.
std::size_t width_of(const std::string& text) {
  std::size_t count = static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
  for (const std::string mark : {"\u20d7", "\u0302"}) {
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) --count;
  }
  return count;
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, width_of(text)), ' ');
}

struct Widths {
  std::size_t name = 4, value = 5, exact = 5;
  void fit(const WalkValue& v, Precision precision) {
    name = std::max(name, width_of(v.name));
    value = std::max(value, width_of(shown(v.value, precision)));
    exact = std::max(exact, width_of(v.exact));
  }
};

/// The value's formula as text; empty for none, and where the value's name is the same.
std::string computed_as(const WalkValue& value) {
  const std::string text = text_of(value.formula);
  return text == value.name ? "" : text;
}

std::string row(const WalkValue& v, const Widths& widths, Precision precision) {
  std::string text = fmt::format(
      "   {}  {}  {}  {}  {}", padded(v.name, widths.name), padded(shown(v.value, precision), widths.value),
      padded(v.exact, widths.exact), padded(v.bits_lost < 0.05 ? "-" : fmt::format("{:.1f}", v.bits_lost), 9),
      padded(v.error_bound == 0 ? "-" : rough(v.error_bound, 2), 11));
  if (const std::string formula = computed_as(v); !formula.empty()) text += "  = " + formula;
  return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
}

std::string table(const std::vector<WalkValue>& values, const Widths& widths, Precision precision) {
  std::string text;
  for (const WalkValue& value : values) text += row(value, widths, precision);
  return text;
}

std::string steps_of(const Walkthrough& walk) {
  Widths widths;
  const char* const arithmetic = name_of(walk.precision);
  widths.value = std::char_traits<char>::length(arithmetic);
  for (const WalkValue& value : walk.inputs) widths.fit(value, walk.precision);
  for (const WalkStep& step : walk.steps) {
    for (const WalkValue& value : step.values) widths.fit(value, walk.precision);
  }
  const std::string name =
      "   " + padded("name", widths.name) + "  " + padded(arithmetic, widths.value) + "  ";
  std::string text = "Inputs\n" + name + "stored value\n";
  for (const WalkValue& v : walk.inputs)
    text += fmt::format("   {}  {}  {}\n", padded(v.name, widths.name),
                        padded(shown(v.value, walk.precision), widths.value), v.exact);
  text += "\n" + name + padded("exact", widths.exact) + "  bits lost  error bound\n";
  for (std::size_t i = 0; i < walk.steps.size(); ++i) {
    const WalkStep& step = walk.steps[i];
    text += fmt::format("{}. {}\n   {}\n{}", i + 1, step.title, step.meaning,
                        table(step.values, widths, walk.precision));
    if (!step.caption.empty()) text += "   " + step.caption + "\n";
  }
  return text;
}

std::string answer_line(const std::string& who, const CaseReport& report, const Answer* answer) {
  std::string text = "   " + padded(who, 24) + "  " + verdict_of(answer);
  const std::vector<double> values = values_of(answer);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string name = answer == &report.exact ? exact_root_name(report, i) : root_name(report, i);
    text += fmt::format("{} {} = {}", i == 0 ? ":" : ",", name, shown(values[i], report.one.precision));
  }
  return text + "\n";
}

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

std::string explain_text(const CaseReport& report) {
  std::string text;
  if (report.walk) {
    text += fmt::format("{}\n({})\n\n{}", report.walk->title, report.walk->source, steps_of(*report.walk));
  }
  text += "Answer\n" + answer_line("exact", report, &report.exact);
  if (report.claimed) {
    text += answer_line(report.method, report, report.claim());
    const auto truth = values_of(&report.exact);
    const auto claim = values_of(report.claim());
    for (std::size_t i = 0; i < std::min(truth.size(), claim.size()); ++i) {
      const double ulps = count_ulps(truth[i], claim[i], report.one.precision);
      text += fmt::format("   {} is {}\n", root_name(report, i), accuracy_in_words(ulps));
    }
  }
  if (report.measured) text += "   " + in_words(*report.measured) + "\n";
  return text + "\n" + conclusion_of(report) + "\n";
}

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
