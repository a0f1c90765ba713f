#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "viz/trace/expression.hpp"

namespace rayproof::viz {
namespace {

using Kind = Expression::Kind;

/// Signs between terms, each with how it is printed.
constexpr std::array<std::pair<std::string_view, const char*>, 10> term_signs{{{"+", "+"},
                                                                               {"−", "−"},
                                                                               {"-", "−"},
                                                                               {"=", "="},
                                                                               {"≤", "≤"},
                                                                               {"≥", "≥"},
                                                                               {"<", "<"},
                                                                               {">", ">"},
                                                                               {",", ","},
                                                                               {"±", "±"}}};
constexpr std::array<std::string_view, 9> other_signs{" ", "(", ")", "/", "|", "√", "^(", "²", "·"};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Recursive descent over sums of products of atoms; whatever it does not know it takes for a letter.
class FormulaReader {
 public:
  explicit FormulaReader(std::string_view text) : text_(text) {}

  Formula all() {
    Formula result = sum();
    while (take(")")) result = with_term(with_term(result, "", make(Kind::name, {}, ")")), "", sum());
    return result;
  }

 private:
  void skip_spaces() {
    while (is_next(" ")) ++at_;
  }
  [[nodiscard]] bool is_at_end() const { return at_ >= text_.size(); }
  [[nodiscard]] bool is_next(std::string_view sign) const { return text_.substr(at_).starts_with(sign); }
  bool take(std::string_view sign) {
    if (!is_next(sign)) return false;
    at_ += sign.size();
    return true;
  }
  const char* take_sign(bool is_in_list = false) {
    skip_spaces();
    if (is_in_list && is_next(",")) return "";
    for (const auto& [sign, printed] : term_signs)
      if (take(sign)) return printed;
    return "";
  }

  /// Up to a closing sign: terms and signs one after another. A bar closes where one is open and an operand
  /// stands before it.
  Formula sum(bool is_in_bars = false, bool is_in_list = false) {
    Formula result;
    while (true) {
      skip_spaces();
      const bool is_closed =
          is_next(")") || (is_in_list && is_next(",")) || (is_in_bars && result && is_next("|"));
      if (is_at_end() || is_closed) return result != nullptr ? result : make(Kind::name, {});
      const char* const sign = take_sign(is_in_list);
      const char* const second = take_sign(is_in_list);  // as in "= −1"
      const Formula term = product();
      result = with_term(result, sign, *second == '\0' ? term : with_term(nullptr, second, term));
    }
  }

  /// Factors and divisors from left to right: a quotient's numerator is all of the product before it.
  Formula product() {
    Formula result = factor();
    while (true) {
      skip_spaces();
      const bool is_dot = take("·");
      if (is_dot || take("×")) {
        result = make(Kind::product, {result, factor()}, is_dot ? "·" : "×");
      } else if (take("/")) {
        result = make(Kind::quotient, {result, factor()});
      } else {
        return result;
      }
    }
  }

  /// A power, or a quotient that is written as one: "1/a", without a space.
  Formula factor() {
    skip_spaces();
    const Formula above = power();
    if (!take("/")) return above;
    skip_spaces();
    return make(Kind::quotient, {above, power()});
  }

  Formula power() {
    const Formula base = atom();
    if (take("²")) return make(Kind::power, {base, number_formula("2")});
    return take("^") ? make(Kind::power, {base, atom()}) : base;
  }

  Formula atom() {
    if (take("√")) return make(Kind::root, {power()});
    if (is_next("(")) {
      const std::vector<Formula> inside = list();
      return inside.size() == 1 ? inside[0] : make(Kind::call, inside);
    }
    if (take("|")) {
      const Formula inside = sum(true);
      take("|");
      return make(Kind::absolute, {inside});
    }
    const std::string name = word();
    if (!name.empty() && is_digit(name[0])) return number_formula(name);
    if (name.empty() || !is_next("(")) return make(Kind::name, {}, name);
    const std::vector<Formula> arguments = list();
    return name == "dot" && arguments.size() == 2 ? make(Kind::dot, arguments)
                                                  : make(Kind::call, arguments, name);
  }

  /// What stands in parentheses, parted by commas.
  std::vector<Formula> list() {
    take("(");
    std::vector<Formula> parts{sum(false, true)};
    while (take(",")) parts.push_back(sum(false, true));
    take(")");
    return parts;
  }

  std::string word() {
    const std::size_t begin = at_;
    while (!is_at_end() && !ends_word()) ++at_;
    // A sign of no meaning here, of one byte or more.
    if (at_ == begin && !is_at_end() && !is_next(")") && !is_next(",")) {
      do ++at_;
      while (!is_at_end() && (static_cast<unsigned char>(text_[at_]) & 0xC0) == 0x80);
    }
    return std::string(text_.substr(begin, at_ - begin));
  }

  [[nodiscard]] bool ends_word() const {
    // The sign of a number's exponent belongs to the number: "1.5e-7".
    const bool is_exponent = at_ > 1 && text_[at_ - 1] == 'e' && is_digit(text_[at_ - 2]);
    if (is_next("-") && is_exponent) return false;
    const auto is_here = [&](std::string_view sign) { return is_next(sign); };
    return std::any_of(other_signs.begin(), other_signs.end(), is_here) || is_next("×") ||
           std::any_of(term_signs.begin(), term_signs.end(),
                       [&](const auto& sign) { return is_here(sign.first); });
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

Formula read_formula(std::string_view text) { return FormulaReader(text).all(); }

}  // namespace rayproof::viz
