#include "viz/trace/expression.hpp"

#include <array>

#include "viz/trace/name_parts.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

using Kind = Expression::Kind;

Formula shared(Expression e) { return std::make_shared<const Expression>(std::move(e)); }

std::string bracketed(const Expression& whole, std::size_t part) {
  const Formula& inside = whole.parts[part];
  const std::string text = text_of(inside);
  return strength_of(*inside) < least_strength(whole, part) ? "(" + text + ")" : text;
}

std::string name_in_text(const Expression& e) {
  const std::string vector = without_axis(e.text);
  const bool is_compound_vector = !e.parts.empty() && vector != e.text;
  return is_compound_vector ? "(" + vector + ")" + e.text.substr(vector.size()) : e.text;
}

std::string sum_in_text(const Expression& e) {
  std::string text;
  for (std::size_t i = 0; i < e.parts.size(); ++i) {
    const std::string& sign = e.signs[i];
    const std::string space = i == 0 || sign == "," ? "" : " ";
    text += space + sign + (i == 0 || sign.empty() ? "" : " ") + bracketed(e, i);
  }
  return text;
}

std::string list_in_text(const Expression& e) {
  std::string text;
  for (const Formula& part : e.parts) text += (text.empty() ? "" : ", ") + text_of(part);
  return "(" + text + ")";
}

}  // namespace

Strength strength_of(const Expression& e) {
  switch (e.kind) {
    case Kind::name:
      // A quotient as a name, "1/a", is written without spaces.
      if (e.parts.empty() || without_axis(e.text) != e.text) return Strength::atom;
      return e.parts[0]->kind == Kind::quotient ? Strength::sum : strength_of(*e.parts[0]);
    case Kind::number:
      return e.text.starts_with('-') ? Strength::sum : Strength::atom;
    case Kind::sum:
      return e.parts.size() == 1 ? Strength::sign : Strength::sum;
    case Kind::product:
      return Strength::product;
    case Kind::quotient:
      return Strength::quotient;
    default:
      return Strength::atom;
  }
}

Strength least_strength(const Expression& whole, std::size_t part) {
  switch (whole.kind) {
    case Kind::sum:
      return whole.signs[part].empty() ? Strength::sum : Strength::quotient;
    case Kind::product:
      return whole.text == "×" ? Strength::atom : part == 0 ? Strength::quotient : Strength::product;
    case Kind::quotient:
      return part == 0 ? Strength::quotient : Strength::atom;
    case Kind::power:
      return part == 0 ? Strength::atom : Strength::sum;
    case Kind::root:
    case Kind::dot:
      return Strength::atom;
    default:
      return Strength::sum;
  }
}

Formula make(Kind kind, std::vector<Formula> parts, std::string text) {
  return shared({kind, std::move(text), std::move(parts)});
}

Formula named_formula(const std::string& name, std::vector<double> values) {
  const Formula meaning = read_formula(without_axis(name));
  const bool is_compound = meaning->kind != Kind::name && meaning->kind != Kind::number;
  return shared(
      {Kind::name, name, is_compound ? std::vector{meaning} : std::vector<Formula>{}, {}, std::move(values)});
}

Formula number_formula(const std::string& text, std::vector<double> values) {
  return shared({Kind::number, text, {}, {}, std::move(values)});
}

Formula with_term(const Formula& sum, const std::string& sign, const Formula& term) {
  if (sum == nullptr) return sign.empty() ? term : shared({Kind::sum, {}, {term}, {sign}});
  Expression longer = sum->kind == Kind::sum ? *sum : Expression{Kind::sum, {}, {sum}, {""}};
  longer.parts.push_back(term);
  longer.signs.push_back(sign);
  return shared(std::move(longer));
}

std::string text_of(const Formula& formula) {
  if (formula == nullptr) return "";
  const Expression& e = *formula;
  switch (e.kind) {
    case Kind::name:
      return name_in_text(e);
    case Kind::number:
      return e.text;
    case Kind::sum:
      return sum_in_text(e);
    case Kind::product:
      return bracketed(e, 0) + (e.text == "×" ? " × " : e.text) + bracketed(e, 1);
    case Kind::quotient:
      return bracketed(e, 0) + " / " + bracketed(e, 1);
    case Kind::dot:
      return "dot" + list_in_text(e);
    case Kind::power:
      return bracketed(e, 0) + (text_of(e.parts[1]) == "2" ? "²" : "^(" + text_of(e.parts[1]) + ")");
    case Kind::root:
      return "√" + bracketed(e, 0);
    case Kind::absolute:
      return "|" + text_of(e.parts[0]) + "|";
    case Kind::call:
      return e.text + list_in_text(e);
  }
  return {};
}

std::vector<Formula> terms_of(const Formula& formula) {
  if (formula == nullptr || formula->kind != Kind::sum) return {formula};
  std::vector<Formula> terms;
  for (std::size_t i = 0; i < formula->parts.size(); ++i)
    terms.push_back(with_term(nullptr, formula->signs[i], formula->parts[i]));
  return terms;
}

Formula with_numbers(const Formula& formula, Precision precision) {
  if (formula == nullptr) return nullptr;
  std::vector<Formula> numbers;
  for (const double value : formula->values) numbers.push_back(number_formula(shown(value, precision)));
  if (numbers.size() == 1) return numbers[0];
  if (!numbers.empty()) return make(Kind::call, numbers);
  Expression e = *formula;
  for (Formula& part : e.parts) part = with_numbers(part, precision);
  return shared(std::move(e));
}

}  // namespace rayproof::viz
