#pragma once
/// \file
/// Formulas as trees. They come from what a run has recorded (record.hpp) or from a name (read_formula),
/// and are printed as text here and as MathML by viz/page.

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"

namespace rayproof::viz {

struct Expression;
/// Trees share their branches, and nobody changes them; null for no formula.
using Formula = std::shared_ptr<const Expression>;

struct Expression {
  enum class Kind {
    name,     ///< `text`; "n·o + d" is the name of what is computed by the formula in its part
    number,   ///< `text`
    sum,      ///< of its parts, each with its sign; a negation is a sum of one part
    product,  ///< of two, as are the next three
    cross,
    quotient,
    dot,
    square,
    power,  ///< base and exponent
    root,
    absolute,
    call  ///< of the function `text`; a vector where that is empty
  };
  Kind kind = Kind::name;
  std::string text{};
  std::vector<Formula> parts{};
  std::vector<std::string> signs{};  ///< of a sum: "+", "−", also "=" or "<"; the first is mostly empty
  std::vector<double> values{};  ///< of a name or literal on the tape: one rounded number, more of a vector
};

/// How tightly a formula's outermost operator binds, from the loosest.
enum class Strength { sum, quotient, product, sign, atom };
[[nodiscard]] Strength strength_of(const Expression& e);

/// How a printer writes one kind of expression around and between its parts.
struct Notation {
  const char* open = "";
  const char* between = "";
  const char* close = "";
  bool is_closed = false;  ///< no part needs parentheses, nor does it as a part of a sum or product
};
struct PrintStyle {
  std::array<Notation, 12> notations;  ///< by Expression::Kind
  const char* open;                    ///< of parentheses
  const char* close;
  std::string (*leaf)(const Expression& e);  ///< a name or a number
  std::string (*sign)(const std::string& sign, bool is_first);
  std::string (*function)(const std::string& name);  ///< may be empty
};
/// With no more parentheses than it needs; empty for no formula.
[[nodiscard]] std::string printed(const Formula& formula, const PrintStyle& style);

[[nodiscard]] Formula make(Expression::Kind kind, std::vector<Formula> parts, std::string text = {});
/// Of a name that is a formula itself, with that formula.
[[nodiscard]] Formula named_formula(const std::string& name, std::vector<double> values = {});
[[nodiscard]] Formula number_formula(const std::string& text, std::vector<double> values = {});
/// Adds a term to a sum; with no sum before it, the negation or the term itself.
[[nodiscard]] Formula with_term(const Formula& sum, const std::string& sign, const Formula& term);

/// Reads "(−b − √D) / (2·a)". Never fails: what is no formula becomes names one after another.
[[nodiscard]] Formula read_formula(std::string_view text);

/// "(−b − √D) / (2·a)"; empty for no formula.
[[nodiscard]] std::string text_of(const Formula& formula);

/// The terms of a sum, each with its sign: "b·b − 4·(a + c)" is "b·b" and "−4·(a + c)".
[[nodiscard]] std::vector<Formula> terms_of(const Formula& formula);

/// With the rounded numbers in the place of their names: "3·3 − 4·1·2".
[[nodiscard]] Formula with_numbers(const Formula& formula, Precision precision);

/// "o − C" of "o.x − C.x", "o.y − C.y" and "o.z − C.z"; "a × b" of the components of a cross product; null
/// where the components have no formula in common.
[[nodiscard]] Formula vector_formula(const std::vector<Formula>& components);

/// "dot(a, b)" of "a.x·b.x + a.y·b.y + a.z·b.z"; any other formula as it is.
[[nodiscard]] Formula dot_or(const Formula& formula);

/// A name of one thing, as it is typeset.
struct NameParts {
  std::string letters;  ///< "t" of "t₀", "S" of "S_x"
  std::string index{};  ///< "0" of "t₀", "x" of "S_x" and of "f.x", "1x" of "e₁.x"
};

[[nodiscard]] NameParts parts_of_name(std::string name);

/// "f" of "f.x" and 'x': the vector whose component of that axis has this name; empty where it is none.
[[nodiscard]] std::string vector_of(const std::string& name, char axis);

/// The same for any axis; else the name itself.
[[nodiscard]] std::string without_axis(const std::string& name);

}  // namespace rayproof::viz
