#include "viz/trace/expression.hpp"

#include <array>

#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

using Kind = Expression::Kind;

Formula shared(Expression e) { return std::make_shared<const Expression>(std::move(e)); }

/// Of each kind, in the order of Expression::Kind.
struct Precedence {
  Strength own;
  Strength first = Strength::sum;  ///< the least strength of a part without parentheses
  Strength others = Strength::sum;
};
constexpr std::array<Precedence, 12> precedences{{{Strength::atom},
                                                  {Strength::atom},
                                                  {Strength::sum, Strength::sum, Strength::quotient},
                                                  {Strength::product, Strength::quotient, Strength::product},
                                                  {Strength::product, Strength::atom, Strength::atom},
                                                  {Strength::quotient, Strength::quotient, Strength::atom},
                                                  {Strength::product, Strength::atom, Strength::atom},
                                                  {Strength::atom, Strength::atom},
                                                  {Strength::atom, Strength::atom},
                                                  {Strength::atom, Strength::atom},
                                                  {Strength::atom},
                                                  {Strength::atom}}};

std::size_t row_of(const Expression& e) { return static_cast<std::size_t>(e.kind); }

bool needs_parentheses(const Expression& whole, std::size_t part, const PrintStyle& style) {
  const Expression& e = *whole.parts[part];
  const bool is_base = part == 0 && (whole.kind == Kind::square || whole.kind == Kind::power);
  const Expression& meaning = e.kind == Kind::name && !e.parts.empty() ? *e.parts[0] : e;
  if (style.notations.at(row_of(whole)).is_closed) return false;
  if (style.notations.at(row_of(meaning)).is_closed && !is_base) return false;
  const bool is_first = part == 0 && (whole.kind != Kind::sum || whole.signs[0].empty());
  const Precedence& precedence = precedences.at(row_of(whole));
  return strength_of(e) < (is_first ? precedence.first : precedence.others);
}

const PrintStyle text_style{
    {{{},
      {},
      {},
      {"", "·"},
      {"", " × "},
      {"", " / "},
      {"dot(", ", ", ")", true},
      {"", "", "²"},
      {"", "^(", ")"},
      {"√"},
      {"|", "", "|", true},
      {"(", ", ", ")", true}}},
    "(",
    ")",
    [](const Expression& e) {
      const std::string vector = without_axis(e.text);
      const bool is_compound_vector = !e.parts.empty() && vector != e.text;
      return is_compound_vector ? "(" + vector + ")" + e.text.substr(vector.size()) : e.text;
    },
    [](const std::string& sign, bool is_first) {
      return is_first ? sign : sign.empty() ? " " : sign == "," ? ", " : " " + sign + " ";
    },
    [](const std::string& name) { return name; }};

}  // namespace

Strength strength_of(const Expression& e) {
  if (e.text.starts_with('-') && e.kind == Kind::number) return Strength::sum;
  if (e.kind == Kind::sum && e.parts.size() == 1) return Strength::sign;
  // A quotient as a name, "1/a", is written without spaces.
  if (e.kind == Kind::name && !e.parts.empty() && without_axis(e.text) == e.text)
    return e.parts[0]->kind == Kind::quotient ? Strength::sum : strength_of(*e.parts[0]);
  return precedences.at(row_of(e)).own;
}

std::string printed(const Formula& formula, const PrintStyle& style) {
  if (formula == nullptr) return "";
  const Expression& e = *formula;
  if (e.kind == Kind::name || e.kind == Kind::number) return style.leaf(e);
  const Notation& notation = style.notations.at(row_of(e));
  std::string text = style.function(e.text) + notation.open;
  for (std::size_t i = 0; i < e.parts.size(); ++i) {
    text += e.kind == Kind::sum ? style.sign(e.signs[i], i == 0) : i == 0 ? "" : notation.between;
    const std::string part = printed(e.parts[i], style);
    text += needs_parentheses(e, i, style) ? style.open + part + style.close : part;
  }
  return text + notation.close;
}

std::string text_of(const Formula& formula) { return printed(formula, text_style); }

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
