#include <fmt/format.h>

#include <algorithm>

#include "case/escape.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/page/page.hpp"
#include "viz/picture/picture.hpp"
#include "viz/scene/shown_items.hpp"
#include "viz/trace/expression.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

using Kind = Expression::Kind;

std::string row(const std::string& inside) { return "<mrow>" + inside + "</mrow>"; }
std::string sign(const std::string& text) { return text.empty() ? "" : "<mo>" + escaped(text) + "</mo>"; }
std::string upright(const std::string& text) {
  return "<mi mathvariant=\"normal\">" + escaped(text) + "</mi>";
}

std::string typeset_leaf(const Expression& e);

constexpr const char* open_fence = "<mrow><mo stretchy=\"false\">(</mo><mrow>";
constexpr const char* close_fence = "</mrow><mo stretchy=\"false\">)</mo></mrow>";
const PrintStyle math_style{
    {{{},
      {},
      {},
      {"", "<mo>·</mo>"},
      {"", "<mo>×</mo>"},
      {"<mfrac><mrow>", "</mrow><mrow>", "</mrow></mfrac>", true},
      {"", "<mo>·</mo>"},
      {"<msup><mrow>", "", "</mrow><mn>2</mn></msup>"},
      {"<msup><mrow>", "</mrow><mrow>", "</mrow></msup>"},
      {"<msqrt>", "", "</msqrt>", true},
      {"<mrow><mo stretchy=\"false\">|</mo><mrow>", "", "</mrow><mo stretchy=\"false\">|</mo></mrow>", true},
      {open_fence, "<mo>,</mo>", close_fence, true}}},
    open_fence,
    close_fence,
    typeset_leaf,
    [](const std::string& text, bool /*is_first*/) { return sign(text); },
    [](const std::string& name) { return name.empty() ? "" : upright(name); }};

std::string typeset_name(const std::string& name) {
  const NameParts parts = parts_of_name(name);
  const std::string letters =
      parts.letters.size() > 1 ? upright(parts.letters) : "<mi>" + escaped(parts.letters) + "</mi>";
  return parts.index.empty() ? letters : "<msub>" + letters + "<mi>" + escaped(parts.index) + "</mi></msub>";
}

std::string typeset_leaf(const Expression& e) {
  if (e.kind == Kind::number && e.text.starts_with('-'))
    return sign("−") + "<mn>" + escaped(e.text.substr(1)) + "</mn>";
  if (e.kind == Kind::number) return "<mn>" + escaped(e.text) + "</mn>";
  if (e.parts.empty()) return typeset_name(e.text);
  const std::string meaning = printed(e.parts[0], math_style);
  if (without_axis(e.text) == e.text) return meaning;
  const bool is_bare = strength_of(*e.parts[0]) == Strength::atom;
  return "<msub>" + (is_bare ? row(meaning) : open_fence + meaning + close_fence) + "<mi>" + e.text.back() +
         "</mi></msub>";
}

/// A formula typeset term by term, so that a browser can break the line between them.
std::string in_terms(const Formula& formula) {
  std::string html;
  for (const Formula& term : terms_of(formula)) html += math_ml(term) + " ";
  return html;
}

/// A formula of numbers: typeset where each term is sure to fit on a phone, else as text, which breaks
/// anywhere.
std::string numbers_in_terms(const Formula& put_in) {
  constexpr double phone_width = 240;
  const auto terms = terms_of(put_in);
  const bool fits = std::ranges::all_of(
      terms, [](const Formula& term) { return text_width(text_of(term), 18) <= phone_width; });
  return fits ? in_terms(put_in) : html_text(text_of(put_in));
}

std::string equation(const StageValue& value, Precision precision) {
  const auto part = [](const std::string& html) { return fmt::format("<span>= {}</span> ", html); };
  std::string html = math_ml(named_formula(value.name)) + " ";
  if (!formula_beside_name(value).empty()) {
    html += part(in_terms(value.formula));
    if (value.put_in != nullptr && text_of(value.put_in) != text_of(value.formula))
      html += part(numbers_in_terms(value.put_in));
  }
  return fmt::format("<div class=\"equation\">{}= <b class=\"claimed\">{}</b></div>\n", html,
                     html_text(shown(value, precision)));
}

std::string row(const WalkValue& v, Precision precision) {
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td class=\"claimed\">{}</td><td "
      "class=\"exact\">{}</td><td title=\"error bound {}\"{}>{}</td></tr>\n",
      math_ml(named_formula(v.name)), shown(v.value, precision), v.exact, rough(v.error_bound, 2),
      v.bits_lost >= 3 ? " class=\"lost\"" : "",
      v.bits_lost < 0.05 ? "–" : fmt::format("{:.1f}", v.bits_lost));
}

std::string table(const std::vector<StageValue>& values, Precision precision) {
  if (values.empty()) return "";
  // A given number is exact as it is stored.
  const bool are_given = std::ranges::all_of(
      values, [](const StageValue& value) { return value.components.front().formula == nullptr; });
  std::string html = fmt::format(
      "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Values\"><table><thead><tr><th "
      "scope=\"col\">name</th>"
      "<th scope=\"col\">{}</th><th scope=\"col\">{}</th><th scope=\"col\">bits "
      "lost</th></tr></thead><tbody>\n",
      name_of(precision), are_given ? "stored value" : "exact");
  for (const StageValue& value : values) {
    for (const WalkValue& v : value.components) html += row(v, precision);
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace

std::string math_ml(const Formula& formula) {
  return "<math>" + row(printed(formula, math_style)) + "</math>";
}

std::string html_text(const std::string& text) { return escaped(typeset(text)); }

std::string flat_still(const Stage& stage, std::size_t step) {
  return to_svg(scene_picture(stage, step, 640, 640 / view_aspect));
}

std::string step_section(const Stage& stage, std::size_t number, const Still& still) {
  const StageStep& step = stage.steps[number];
  std::string html = fmt::format(
      "<section class=\"step\" aria-labelledby=\"title-{0}\">\n<h2 id=\"title-{0}\">{0}. {1}</h2>\n",
      number + 1, html_text(step.title));
  html += "<figure>" + still(stage, number) + "</figure>\n";
  std::string equations;
  for (const StageValue& value : step.values) equations += equation(value, stage.precision);
  const bool is_typeset = number > 0 && !equations.empty();
  const std::string& words = is_typeset ? step.words : step.caption;
  if (!words.empty()) html += fmt::format("<p>{}</p>\n", html_text(words));
  if (is_typeset) html += equations;
  if (!step.digits.empty()) html += fmt::format("<p class=\"soft\">{}</p>\n", html_text(step.digits));
  return html + table(step.values, stage.precision) + "</section>\n";
}

}  // namespace rayproof::viz
