#include <fmt/format.h>

#include <array>
#include <optional>

#include "viz/trace/numbers.hpp"
#include "viz/trace/tape.hpp"

namespace rayproof::viz {
namespace {

/// How tightly an expression's outermost operator binds.
enum Strength { sum, product, sign, atom };

struct Expression {
  std::string text;
  Strength strength = atom;
};

std::string bracketed(const Expression& e, Strength least) {
  return e.strength < least ? fmt::format("({})", e.text) : e.text;
}

/// A name may be a formula itself: "1/a" and "n·o + d" want parentheses in a product.
Strength strength_of(const std::string& name) {
  int depth = 0;
  Strength loosest = atom;
  for (std::size_t i = 0; i < name.size(); ++i) {
    depth += name[i] == '(' ? 1 : name[i] == ')' ? -1 : 0;
    if (depth > 0) continue;
    const bool is_sum = name[i] == '/' || name.compare(i, 3, " + ") == 0 || name.compare(i, 3, " - ") == 0;
    if (is_sum) return sum;
    if (name.compare(i, 2, "·") == 0) loosest = product;
  }
  return loosest;
}

class FormulaWriter {
 public:
  /// With numbers of the given precision in the place of names, where one is given.
  explicit FormulaWriter(const Tape& tape, std::optional<Precision> numbers = {})
      : tape_(tape), numbers_(numbers) {}

  [[nodiscard]] Expression operand(OperationId id) const {
    if (id == unrecorded) return {"?", atom};
    const std::string& name = tape_.at(id).name;
    if (name.empty()) return write(id);
    if (numbers_) return number(id);
    const std::size_t dot = name.rfind('.');
    const bool is_component = dot != std::string::npos && dot > 0 && dot + 2 == name.size();
    const std::string vector = is_component ? name.substr(0, dot) : "";
    if (is_component && strength_of(vector) < atom)
      return {fmt::format("({}){}", vector, name.substr(dot)), atom};
    return {name, strength_of(name)};
  }

  [[nodiscard]] Expression write(OperationId id) const {
    const Operation<Shadow>& o = tape_.at(id);
    if (const auto short_form = dot_product(id)) return {*short_form, atom};
    const auto at = [&](std::size_t i) { return operand(o.operands[i]); };
    switch (o.op) {
      case Operator::constant:
        if (numbers_) return number(id);
        return {o.name.empty() ? rough(o.value, 17) : o.name, o.value < 0 ? sum : atom};
      case Operator::negate:
        return {fmt::format("−{}", bracketed(at(0), product)), sign};
      case Operator::add:
        return {fmt::format("{} + {}", at(0).text, bracketed(at(1), product)), sum};
      case Operator::subtract:
        return {fmt::format("{} − {}", at(0).text, bracketed(at(1), product)), sum};
      case Operator::multiply:
        return {fmt::format("{}·{}", bracketed(at(0), product), bracketed(at(1), product)), product};
      case Operator::divide:
        return {fmt::format("{} / {}", bracketed(at(0), product), bracketed(at(1), atom)), product};
      case Operator::square_root:
        return {fmt::format("√{}", bracketed(at(0), atom)), atom};
      case Operator::fused_multiply_add:
        return {fmt::format("fma({}, {}, {})", at(0).text, at(1).text, at(2).text), atom};
      case Operator::absolute:
        return {fmt::format("|{}|", at(0).text), atom};
      case Operator::copy_sign:
        return {fmt::format("copysign({}, {})", at(0).text, at(1).text), atom};
      case Operator::exponent:
        return {fmt::format("exponent({})", at(0).text), atom};
      case Operator::scale_exponent:
        return {fmt::format("{}·2^({})", bracketed(at(0), product), at(1).text), product};
      case Operator::floor:
        return {fmt::format("floor({})", at(0).text), atom};
    }
    return {};
  }

 private:
  [[nodiscard]] Expression number(OperationId id) const {
    const double value = tape_.at(id).value;
    // A negative number stands in parentheses wherever an operator is next to it.
    return {shown(value, *numbers_), value < 0 ? sum : atom};
  }

  /// "d" and "f" of d.x·f.x, for the given component.
  [[nodiscard]] std::optional<std::array<std::string, 2>> factors(OperationId id,
                                                                  const char* component) const {
    if (id == unrecorded || tape_.at(id).op != Operator::multiply || !tape_.at(id).name.empty()) return {};
    std::array<std::string, 2> names;
    for (std::size_t i = 0; i < 2; ++i) {
      const OperationId factor = tape_.at(id).operands[i];
      if (factor == unrecorded || !tape_.at(factor).name.ends_with(component)) return {};
      names[i] = tape_.at(factor).name.substr(0, tape_.at(factor).name.size() - 2);
    }
    return names;
  }

  /// x·x + y·y + z·z of two named vectors is their dot product.
  [[nodiscard]] std::optional<std::string> dot_product(OperationId id) const {
    const auto& all = tape_.at(id);
    if (all.op != Operator::add || all.operands[0] == unrecorded) return {};
    const auto& xy = tape_.at(all.operands[0]);
    if (xy.op != Operator::add || !xy.name.empty()) return {};
    const auto x = factors(xy.operands[0], ".x");
    const auto y = factors(xy.operands[1], ".y");
    const auto z = factors(all.operands[1], ".z");
    if (!x || x != y || y != z) return {};
    if (!numbers_) return fmt::format("dot({}, {})", (*x)[0], (*x)[1]);
    const std::array<OperationId, 3> terms{xy.operands[0], xy.operands[1], all.operands[1]};
    return fmt::format("dot({}, {})", vector(terms, 0), vector(terms, 1));
  }

  /// One factor of each of a dot product's terms: "(1, 2, 3)".
  [[nodiscard]] std::string vector(const std::array<OperationId, 3>& terms, std::size_t factor) const {
    const auto at = [&](std::size_t i) { return number(tape_.at(terms[i]).operands[factor]).text; };
    return fmt::format("({}, {}, {})", at(0), at(1), at(2));
  }

  const Tape& tape_;
  std::optional<Precision> numbers_;
};

}  // namespace

std::string formula_of(const Tape& tape, OperationId id) { return FormulaWriter(tape).write(id).text; }

std::string numbers_of(const Tape& tape, OperationId id, Precision precision) {
  return FormulaWriter(tape, precision).write(id).text;
}

}  // namespace rayproof::viz
