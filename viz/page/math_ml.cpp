#include "viz/page/math_ml.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <string_view>
#include <utility>
#include <vector>

#include "case/escape.hpp"
#include "viz/page/math_names.hpp"

namespace rayproof::viz {
namespace {

/// Signs that end a name, each with the operator that it stands for.
constexpr std::array<std::pair<std::string_view, const char*>, 12> operators{{{"+", "+"},
                                                                              {"−", "−"},
                                                                              {"-", "−"},
                                                                              {"·", "·"},
                                                                              {"×", "×"},
                                                                              {"=", "="},
                                                                              {"≤", "≤"},
                                                                              {"≥", "≥"},
                                                                              {"<", "&lt;"},
                                                                              {">", "&gt;"},
                                                                              {",", ","},
                                                                              {"±", "±"}}};

std::string row(const std::string& inside) { return "<mrow>" + inside + "</mrow>"; }
/// Recursive descent over sums of products of atoms; whatever it does not know it takes for a letter.
class Typesetter {
 public:
  explicit Typesetter(std::string_view text) : text_(text) {}

  std::string all() {
    std::string result = sum();
    while (at_ < text_.size()) {  // a stray closing parenthesis
      result += fmt::format("<mo>{}</mo>", escaped(std::string(1, text_[at_])));
      ++at_;
      result += sum();
    }
    return row(result);
  }

 private:
  void skip_spaces() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  [[nodiscard]] bool is_next(std::string_view sign) const { return text_.substr(at_).starts_with(sign); }
  bool take(std::string_view sign) {
    if (!is_next(sign)) return false;
    at_ += sign.size();
    return true;
  }

  /// Everything up to a closing sign: terms and operators one after another. A bar closes where one is open
  /// and an operand stands before it.
  std::string sum(bool is_in_bars = false) {
    std::string result;
    bool is_after_operand = false;
    while (true) {
      skip_spaces();
      if (at_ >= text_.size() || is_next(")")) return result;
      if (is_next("|") && is_in_bars && is_after_operand) return result;
      const char* const sign = take_operator();
      result += sign != nullptr ? fmt::format("<mo>{}</mo>", sign) : product();
      is_after_operand = sign == nullptr;
    }
  }

  const char* take_operator() {
    for (const auto& [sign, typeset] : operators) {
      if (take(sign)) return typeset;
    }
    return nullptr;
  }

  /// Factors and divisors from left to right: a quotient's numerator is all of the product before it.
  std::string product() {
    std::string result = factor();
    std::string above = bare_;
    while (true) {
      skip_spaces();
      const bool is_dot = take("·");
      if (is_dot || take("×")) {
        skip_spaces();
        result += fmt::format("<mo>{}</mo>{}", is_dot ? "·" : "×", factor());
        above = row(result);
      } else if (take("/")) {
        skip_spaces();
        (void)factor();
        result = above = fmt::format("<mfrac>{}{}</mfrac>", above, bare_);
      } else {
        bare_ = above;
        return result;
      }
    }
  }

  /// An atom, or a quotient that is written as one: "1/a", without a space.
  std::string factor() {
    std::string result = atom();
    if (!take("/")) return result;
    skip_spaces();
    const std::string above = bare_;
    (void)atom();
    result = fmt::format("<mfrac>{}{}</mfrac>", above, bare_);
    return bare_ = result;
  }

  /// One operand; `bare_` is the same without the parentheses that a fraction's bar makes needless.
  std::string atom() {
    std::string result = simple_atom();
    const std::string inside = bare_;
    if (is_next("^(") || is_next("²")) {
      const bool is_square = take("²");
      if (!is_square) take("^");
      const std::string power = is_square ? "<mn>2</mn>" : atom();
      result = fmt::format("<msup>{}{}</msup>", row(result), power);
      bare_ = result;
    } else {
      bare_ = inside;
    }
    return result;
  }

  std::string simple_atom() {
    if (take("√")) {
      (void)atom();
      const std::string inside = bare_;
      return bare_ = fmt::format("<msqrt>{}</msqrt>", inside);
    }
    if (take("(")) {
      const std::string inside = row(sum());
      take(")");
      const std::string result =
          fmt::format("<mo stretchy=\"false\">(</mo>{}<mo stretchy=\"false\">)</mo>", inside);
      bare_ = inside;
      return row(result);
    }
    if (take("|")) {
      const std::string inside = row(sum(true));
      take("|");
      return bare_ = row(fmt::format("<mo stretchy=\"false\">|</mo>{}<mo stretchy=\"false\">|</mo>", inside));
    }
    return bare_ = word();
  }

  std::string word() {
    if (at_ >= text_.size()) return "<mrow></mrow>";
    const std::size_t begin = at_;
    while (at_ < text_.size() && !ends_word()) ++at_;
    if (at_ == begin) {  // a sign of no meaning here, of one byte or more
      do ++at_;
      while (at_ < text_.size() && (static_cast<unsigned char>(text_[at_]) & 0xC0) == 0x80);
    }
    const std::string text(text_.substr(begin, at_ - begin));
    const bool is_number = std::isdigit(static_cast<unsigned char>(text[0])) != 0;
    if (is_number) return fmt::format("<mn>{}</mn>", escaped(text));
    if (!is_next("(")) return typeset_name(text);
    if (text == "dot") return dot_product();
    const std::string argument = simple_atom();  // a function's
    return row(fmt::format("<mi mathvariant=\"normal\">{}</mi>{}", escaped(text), argument));
  }

  /// "dot(a, b)" as a·b.
  std::string dot_product() {
    take("(");
    const std::string first = argument();
    take(",");
    skip_spaces();
    const std::string second = argument();
    take(")");
    return row(first + "<mo>·</mo>" + second);
  }

  /// Up to the comma or parenthesis that ends it.
  std::string argument() {
    std::string result;
    while (true) {
      skip_spaces();
      if (at_ >= text_.size() || is_next(")") || is_next(",")) return row(result);
      const char* const sign = take_operator();
      result += sign != nullptr ? fmt::format("<mo>{}</mo>", sign) : product();
    }
  }

  [[nodiscard]] bool ends_word() const {
    // The sign of a number's exponent belongs to the number: "1.5e-7".
    const bool is_exponent =
        at_ > 1 && text_[at_ - 1] == 'e' && std::isdigit(static_cast<unsigned char>(text_[at_ - 2])) != 0;
    if (is_next("-") && is_exponent) return false;
    for (const auto& [sign, typeset] : operators) {
      (void)typeset;
      if (is_next(sign)) return true;
    }
    for (const std::string_view sign : {" ", "(", ")", "/", "|", "√", "^(", "²"}) {
      if (is_next(sign)) return true;
    }
    return false;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string bare_{};
};

}  // namespace

std::vector<std::string> terms_of(const std::string& formula) {
  std::vector<std::string> terms{""};
  int depth = 0;
  for (std::size_t i = 0; i < formula.size(); ++i) {
    const std::string_view rest = std::string_view(formula).substr(i);
    const bool is_sign = rest.starts_with(" + ") || rest.starts_with(" − ");
    if (depth == 0 && is_sign) {
      terms.emplace_back();
      continue;  // the space before the sign
    }
    depth += formula[i] == '(' ? 1 : formula[i] == ')' ? -1 : 0;
    terms.back() += formula[i];
  }
  return terms;
}

std::string math_ml(const std::string& formula) { return "<math>" + Typesetter(formula).all() + "</math>"; }

}  // namespace rayproof::viz
