/// \file
/// Faults in the formula for two roots, and in the products that it is made of.

#include <fmt/format.h>

#include "properties/diagnosis/models/curved/quadratic.hpp"
#include "properties/diagnosis/models/curved/root_formula.hpp"
#include "properties/diagnosis/models/curved/shortcuts.hpp"
#include "properties/diagnosis/models/curved/small_discriminant.hpp"
#include "properties/diagnosis/models/curved/wrong_roots.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

/// What is right of most equations that have the root, by the sign of the other one.
template <int root>
Hypothesis in_fixed_place(std::string_view name, std::string_view condition) {
  return gives_one_of(
      name, fixed_place_of<root>,
      kept(fmt::format("where {} the root {} is given always first, or always last, whatever the other one "
                       "is: the two are not sorted there",
                       condition, root)));
}

void add_shortcuts(std::vector<Hypothesis>& all) {
  all.push_back(in_fixed_place<0>("fixed-place-of-0", "c = 0"));
  all.push_back(in_fixed_place<1>("fixed-place-of-1", "a + b + c = 0"));
  all.push_back(in_fixed_place<-1>("fixed-place-of-minus-1", "a - b + c = 0"));
  all.push_back(of(OfSizes::zero, gives("linear-zero-missed", linear_zero_missed,
                                        "where a = 0 a root 0 is left out: it is taken for no root")));
  all.push_back(
      shown_by(has_square, of(OfSizes::zero, gives("zero-missed", zero_missed,
                                                   "every root 0 is left out: it is taken for no root"))));
  all.push_back(gives("other-root-by-sum", by_formula<second_by_sum, first_by_sum>,
                      "of two roots one is right, and the other is -b less that: their sum is -b/a"));
  all.push_back(
      of(OfSizes::type,
         shows("discriminant-in-float", has_discriminant_in_float,
               "the discriminant, or its root, is a float, though the case is of float64", rounding)));
}

}  // namespace

std::vector<Hypothesis> models_of_roots() {
  std::vector<Hypothesis> all{
      of_equation(
          "the answer is right for D = (b/2)² - 4ac: where b is halved the discriminant is (b/2)² - ac",
          gives("discriminant-with-four", by_formula<four_with_half, stable_four_with_half>,
                "the answer is right for D = b² - 4ac where b is l·d: with b = 2 (l·d) it is 4ac, with b = "
                "l·d it "
                "is ac")),
      gives("discriminant-without-four", by_formula<no_four, stable_no_four>,
            "the answer is right for D = b² - ac: a factor 4 is missing in the discriminant"),
      gives("discriminant-with-two", by_formula<two_for_four, stable_two_for_four>,
            "the answer is right for D = b² - 2ac: the factor in the discriminant must be 4"),
      gives("discriminant-plus", by_formula<plus_for_minus, stable_plus_for_minus>,
            "the answer is right for D = b² + 4ac: a sign is wrong in the discriminant"),
      of_equation(
          "the answer is right for 2b: b stands where the reduced formula has b/2",
          gives("whole-b-for-half", by_formula<whole_for_half>,
                "the answer is right for twice the coefficient of t: with b = 2 (l·d) the divisor is 2a "
                "and D = b² - 4ac, with b = l·d they are a and b² - ac")),
      of_equation(
          "the answer is right for b/2: b is halved once too often",
          gives("half-b-for-whole", by_formula<half_for_whole>,
                "the answer is right for half the coefficient of t: with b = l·d the divisor is a and D = "
                "b² - ac, with b = 2 (l·d) they are 2a and b² - 4ac")),
      gives("discriminant-unrooted",
            by_formula<no_root_of_half, no_root_of_whole, no_root_of_chord, stable_no_root_of_half,
                       stable_no_root_of_whole>,
            "the answer is right with D in the place of √D: the square root is missing"),
      gives("root-alone-divided", by_formula<root_divided, root_divided_of_half>,
            "of -b ± √D only √D is divided: parentheses are missing"),
      gives("first-root-part-divided", by_formula<one_by<root_divided, 0>, one_by<root_divided_of_half, 0>>,
            "of (-b - √D) / 2a only √D is divided: parentheses are missing; the other root is right"),
      gives("second-root-part-divided", by_formula<one_by<root_divided, 1>, one_by<root_divided_of_half, 1>>,
            "of (-b + √D) / 2a only √D is divided: parentheses are missing; the other root is right"),
      gives("b-alone-divided", by_formula<b_divided, b_divided_of_half>,
            "of -b ± √D only -b is divided: parentheses are missing"),
      of_equation("the answer is right for a = 1: a is forgotten",
                  gives("a-as-one", a_taken_for_one,
                        "the answer is right where the coefficient a of t² is taken for 1: the direction is "
                        "taken for a unit vector in the equation")),
      gives("undivided", by_formula<undivided, undivided_half>,
            "every number is -b ± √D: the division by 2a is missing"),
      gives("b-not-halved", by_formula<b_not_halved>, "√D is halved, and -b is not"),
      gives("root-not-halved", by_formula<root_not_halved>, "-b is halved, and √D is not"),
      gives("b-of-one-root-negated", by_formula<second_with_b, first_with_b>,
            "of one of the two roots -b has the wrong sign: it is the other one's opposite"),
      gives("root-negated", by_formula<second_root_negated, first_root_negated>,
            "of the two roots q / a and c / q one has the wrong sign"),
      gives("discriminant-clamped", clamped_discriminant,
            "a negative discriminant is taken for 0: every line that passes by is said to touch"),
      gives("one-root-doubled", by_formula<second_doubled, first_doubled>,
            "of the two roots q / a and c / q one is doubled: a factor 2 too many, or too few in a "
            "denominator"),
      gives(
          "one-root-halved", by_formula<second_halved, first_halved>,
          "of the two roots q / a and c / q one is halved: a factor 2 too few, or too many in a denominator"),
      gives("sign-of-zero", sign_of_zero,
            "where b = 0 its sign is taken for 0, and with it q = -(b + sign(b)·√D) / 2: it must be 1 or -1"),
      gives("pure-square-negated", pure_square_negated,
            "where b = 0 the roots are ±√(c/a), and must be ±√(-c/a): a sign is missing"),
      gives("root-upside-down", by_formula<second_upside_down, first_upside_down>,
            "of the two roots q / a and c / q one is upside down: a / q, or q / c"),
      gives("one-root-undivided", by_formula<second_undivided, first_undivided>,
            "of the two roots one alone is divided by a"),
      gives("c-over-a", by_formula<both_divided_by_a>,
            "of the two roots q / a and c / q the second is c / a, which is their product"),
      gives("b-negated", read_as<coefficients_with<0>>, "the answer is right for -b: b has the wrong sign"),
      gives("c-negated", read_as<coefficients_with<1>>, "the answer is right for -c: c has the wrong sign"),
      gives("a-c-exchanged", read_as<coefficients_with<2>>,
            "the answer is right with a and c exchanged: the roots are 1/x"),
      gives("b-c-exchanged", read_as<coefficients_with<3>>, "the answer is right with b and c exchanged"),
      gives("a-b-exchanged", read_as<coefficients_with<4>>, "the answer is right with a and b exchanged"),
      gives_one_of(
          "discriminant-wrong", wrong_discriminant,
          "D is not b² - 4ac: a power, a factor, a coefficient or the sign of a term in it is wrong"),
      gives("double-root-halved", double_root_halved,
            "a double root is half the right one: it is -b/(2a), and -h/a with h = b/2"),
      gives("double-root-doubled", double_root_doubled,
            "a double root is twice the right one: it is -b/(2a)"),
      gives("double-root-negated", double_root_negated, "a double root has the wrong sign: it is -b/(2a)"),
      gives("double-root-undivided", double_root_undivided,
            "a double root is not divided by a, or by 2a, or is multiplied by a: it is -b/(2a)"),
      gives("linear-root-inverted", linear_root_inverted, "where a = 0 the root is -b/c, and must be -c/b"),
  };
  add_shortcuts(all);
  return all;
}

std::vector<Hypothesis> classes_of_roots() {
  return {
      of_equation(
          "what lies half way between the two roots is right, and their distance is not: √D is wrong",
          vague(
              shows("distance-of-roots-wrong", distance_of_roots_wrong,
                    "what lies half way between the two hits is right, and their distance is not: √D, or the "
                    "radius in it, is wrong"))),
      of_equation(
          "the distance of the two roots is right, and what lies half way between is not: -b is wrong",
          vague(shows(
              "middle-of-roots-wrong", middle_of_roots_wrong,
              "the distance of the two hits is right, and what lies half way between is not: -b, or the "
              "centre in it, is wrong"))),
      shows("divides-by-what-cancels", divides_by_what_cancels,
            "both roots lose the same share of their digits: of -b ± √D the one that cancels is divided by "
            "2a, and 2c by it; q must be the sum of two numbers of one sign"),
      vague(shows("q-wrong", number_q_wrong,
                  "the product of the two roots is right, and their sum is not: q = -(b ± √D)/2 is wrong, of "
                  "which the roots are q / a and c / q")),
      of_equation(
          "of two roots one is right and one wrong: their two formulas differ in more than a sign",
          vague(shows(
              "one-root-wrong", one_root_wrong,
              "of two hits one is right and one wrong: their two formulas differ in more than a sign"))),
      shows("double-root-wrong", wrong_where_double, "a double root is wrong: it is -b/(2a)"),
  };
}

}  // namespace rayproof::diagnosis
