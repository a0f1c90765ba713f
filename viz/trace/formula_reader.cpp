#include <algorithm>
#include <array>
#include <cctype>

#include "viz/trace/expression.hpp"

namespace rayproof::viz {
namespace {

using Kind = Expression::Kind;

constexpr std::array<std::string_view, 10> term_signs{"+", "−", "-", "=", "≤", "≥", "<", ">", ",", "±"};
constexpr std::array<std::string_view, 10> other_signs{" ", "(", ")", "/", "|", "√", "^(", "²", "·", "×"};

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
  std::string take_sign() {
    for (const std::string_view sign : term_signs)
      if (take(sign)) return sign == "-" ? "−" : std::string(sign);
    return "";
  }

  /// Up to a closing sign: terms and signs one after another. A bar closes where one is open and an operand
  /// stands before it.
  Formula sum(bool is_in_bars = false, bool is_in_list = false) {
    Formula result;
    while (true) {
      skip_spaces();
      const bool is_bar = is_in_bars && result != nullptr && is_next("|");
      const bool is_closed = is_bar || is_next(")") || (is_in_list && is_next(","));
      if (is_at_end() || is_closed) return result != nullptr ? result : make(Kind::name, {});
      const std::string sign = take_sign();
      result = with_term(result, sign, product());
    }
  }

  /// Factors and divisors from left to right: a quotient's numerator is all of the product before it.
  Formula product() {
    Formula result = factor();
    while (true) {
      skip_spaces();
      const Kind kind = take("·")   ? Kind::product
                        : take("×") ? Kind::cross
                        : take("/") ? Kind::quotient
                                    : Kind::sum;
      if (kind == Kind::sum) return result;
      result = make(kind, {result, factor()});
    }
  }

  /// With its own sign, as in "= −1"; or a quotient that is written as one: "1/a", without a space.
  Formula factor() {
    skip_spaces();
    if (take("−") || take("-")) return with_term(nullptr, "−", factor());
    const Formula above = power();
    return take("/") ? make(Kind::quotient, {above, power()}) : above;
  }

  Formula power() {
    const Formula base = atom();
    if (take("²")) return make(Kind::square, {base});
    return take("^") ? make(Kind::power, {base, atom()}) : base;
  }

  Formula atom() {
    if (take("√")) return make(Kind::root, {power()});
    if (take("|")) {
      const Formula inside = sum(true);
      take("|");
      return make(Kind::absolute, {inside});
    }
    const std::string name = is_next("(") ? "" : word();
    const bool is_number = !name.empty() && is_digit(name[0]);
    if (is_number || !is_next("(")) return make(is_number ? Kind::number : Kind::name, {}, name);
    const std::vector<Formula> inside = list();
    if (name == "dot" && inside.size() == 2) return make(Kind::dot, inside);
    return name.empty() && inside.size() == 1 ? inside[0] : make(Kind::call, inside, name);
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
    return std::ranges::any_of(other_signs, is_here) || std::ranges::any_of(term_signs, is_here);
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

Formula read_formula(std::string_view text) { return FormulaReader(text).all(); }

}  // namespace rayproof::viz
