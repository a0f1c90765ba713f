#include "viz/page/math_ml.hpp"

#include <fmt/format.h>

#include "case/escape.hpp"
#include "viz/trace/name_parts.hpp"

namespace rayproof::viz {
namespace {

using Kind = Expression::Kind;

std::string typeset(const Expression& e);

std::string row(const std::string& inside) { return "<mrow>" + inside + "</mrow>"; }
std::string sign(const std::string& text) { return "<mo>" + escaped(text) + "</mo>"; }
std::string fenced(const std::string& inside, const char* open, const char* close) {
  return row(fmt::format("<mo stretchy=\"false\">{}</mo>{}<mo stretchy=\"false\">{}</mo>", open, row(inside),
                         close));
}

/// As a formula binds on paper: a bar holds a fraction together, and a dot stands between two vectors.
Strength typeset_strength(const Expression& e) {
  const Expression& meaning = e.kind == Kind::name && !e.parts.empty() ? *e.parts[0] : e;
  if (meaning.kind == Kind::quotient) return Strength::atom;
  return e.kind == Kind::dot ? Strength::product : strength_of(e);
}

/// With the parentheses that it needs as a part of the whole.
std::string operand(const Expression& whole, std::size_t part) {
  const Expression& e = *whole.parts[part];
  const bool is_divided_base = whole.kind == Kind::power && part == 0 && e.kind == Kind::quotient;
  const bool is_bare = typeset_strength(e) >= least_strength(whole, part) && !is_divided_base;
  return is_bare ? typeset(e) : fenced(typeset(e), "(", ")");
}

/// As one element.
std::string single(const Formula& e) { return row(typeset(*e)); }

std::string typeset_name(const Expression& e) {
  const std::string vector = without_axis(e.text);
  const bool is_component = vector != e.text;
  if (!e.parts.empty()) {
    if (!is_component) return typeset(*e.parts[0]);
    const bool is_bare = strength_of(*e.parts[0]) == Strength::atom;
    const std::string meaning = typeset(*e.parts[0]);
    return fmt::format("<msub>{}<mi>{}</mi></msub>", is_bare ? row(meaning) : fenced(meaning, "(", ")"),
                       e.text.back());
  }
  const NameParts parts = parts_of_name(e.text);
  std::string name = fmt::format("<mi{}>{}</mi>", parts.letters.size() > 1 ? " mathvariant=\"normal\"" : "",
                                 escaped(parts.letters));
  if (parts.has_arrow) name = fmt::format("<mover>{}<mo>→</mo></mover>", name);
  return parts.index.empty() ? name : fmt::format("<msub>{}<mi>{}</mi></msub>", name, escaped(parts.index));
}

std::string typeset_list(const Expression& e, const char* between) {
  std::string list;
  for (std::size_t i = 0; i < e.parts.size(); ++i) list += (i == 0 ? "" : sign(between)) + operand(e, i);
  return list;
}

std::string typeset_sum(const Expression& e) {
  std::string sum;
  for (std::size_t i = 0; i < e.parts.size(); ++i)
    sum += (e.signs[i].empty() ? "" : sign(e.signs[i])) + operand(e, i);
  return sum;
}

std::string typeset_number(const std::string& text) {
  return text.starts_with('-') ? sign("−") + typeset_number(text.substr(1))
                               : "<mn>" + escaped(text) + "</mn>";
}

/// Without a row around it.
std::string typeset(const Expression& e) {
  switch (e.kind) {
    case Kind::name:
      return typeset_name(e);
    case Kind::number:
      return typeset_number(e.text);
    case Kind::sum:
      return typeset_sum(e);
    case Kind::product:
      return typeset_list(e, e.text.c_str());
    case Kind::dot:
      return typeset_list(e, "·");
    case Kind::quotient:
      return "<mfrac>" + single(e.parts[0]) + single(e.parts[1]) + "</mfrac>";
    case Kind::power:
      return "<msup>" + row(operand(e, 0)) + single(e.parts[1]) + "</msup>";
    case Kind::root:
      return "<msqrt>" + typeset(*e.parts[0]) + "</msqrt>";
    case Kind::absolute:
      return fenced(typeset(*e.parts[0]), "|", "|");
    case Kind::call:
      return (e.text.empty() ? "" : "<mi mathvariant=\"normal\">" + escaped(e.text) + "</mi>") +
             fenced(typeset_list(e, ","), "(", ")");
  }
  return {};
}

}  // namespace

std::string math_ml(const Formula& formula) {
  return "<math>" + (formula == nullptr ? row("") : single(formula)) + "</math>";
}

}  // namespace rayproof::viz
