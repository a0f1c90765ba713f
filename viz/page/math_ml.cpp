#include "viz/page/page.hpp"

#include "case/escape.hpp"
#include "viz/trace/expression.hpp"

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

}  // namespace

std::string math_ml(const Formula& formula) {
  return "<math>" + row(printed(formula, math_style)) + "</math>";
}

}  // namespace rayproof::viz
