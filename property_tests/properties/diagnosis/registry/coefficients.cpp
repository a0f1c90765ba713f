/// \file
/// Faults in what the formula for two roots is made of: products, coefficients and limits of these.

#include <fmt/format.h>

#include "properties/diagnosis/models/curved/coefficients.hpp"
#include "properties/diagnosis/models/curved/products.hpp"
#include "properties/diagnosis/models/curved/quadratic.hpp"
#include "properties/diagnosis/models/curved/shortcuts.hpp"
#include "properties/diagnosis/models/curved/small_discriminant.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

using Equation = Quadratic<double>;

/// The term of each coordinate in a dot product.
template <Product product>
void add_terms(std::vector<Hypothesis>& all, std::string_view name, std::string_view product_in_words) {
  const auto add = [&](char coordinate, Predict predict) {
    all.push_back(gives_one_of(
        kept(fmt::format("{}-{}", name, coordinate)), predict,
        kept(fmt::format(
            "the term with {} of {} is wrong: its sign, or another coordinate in it, or it is missing",
            coordinate, product_in_words))));
  };
  add('x', wrong_term<product, 0>);
  add('y', wrong_term<product, 1>);
  add('z', wrong_term<product, 2>);
}

/// An absolute epsilon on the discriminant, from either side of 0; the many answers that it foresees of one
/// case fit single ones by chance.
template <int... power>
void add_small_discriminants(std::vector<Hypothesis>& all) {
  (all.push_back(
       of(OfSizes::small,
          gives_to_all(
              kept(fmt::format("discriminant-negative-1e{}", power)), negative_discriminant<power>,
              kept(fmt::format("a discriminant D that is negative by less than about 1e{} is taken for 0: "
                               "an absolute epsilon on D",
                               power))))),
   ...);
  (all.push_back(of(
       OfSizes::small,
       gives_to_all(kept(fmt::format("discriminant-small-1e{}", power)), small_discriminant<power>,
                    kept(fmt::format("a discriminant D below about 1e{} is taken for 0, or for negative: an "
                                     "absolute epsilon on D",
                                     power))))),
   ...);
}

template <int... power>
void add_nearly_double_roots(std::vector<Hypothesis>& all) {
  (all.push_back(
       gives(kept(fmt::format("nearly-double-1e{}", power)), nearly_double_root<power>,
             kept(fmt::format("two roots are taken for a double one where D is below about 1e{} of b²: a "
                              "tolerance relative to b²",
                              power)))),
   ...);
}

template <int... power>
void add_small_a(std::vector<Hypothesis>& all) {
  (all.push_back(
       of(OfSizes::small, gives(kept(fmt::format("small-a-1e{}", power)), read_as<small_a_as_zero<power>>,
                                kept(fmt::format("an a below about 1e{} is taken for 0, and the equation "
                                                 "for a linear one: an absolute epsilon",
                                                 power))))),
   ...);
}

template <int... power>
void add_large_b(std::vector<Hypothesis>& all) {
  (all.push_back(
       gives(kept(fmt::format("large-b-1e{}", power)), large_b_as_linear<power>,
             kept(fmt::format("an equation with b² above about 1e{} |ac| is taken for a linear one: the "
                              "farther root, about -b/a, is dropped",
                              power)))),
   ...);
}

template <int... power>
void add_small_a_beside_b(std::vector<Hypothesis>& all) {
  (all.push_back(
       gives(kept(fmt::format("small-a-beside-b-1e{}", power)), read_as<small_a_beside_b<power>>,
             kept(fmt::format("an a below about 1e{} of b is taken for 0, and the equation for a linear "
                              "one: a tolerance relative to b",
                              power)))),
   ...);
}

/// The same of c, or b, and of each beside the other.
template <double Equation::*small, double Equation::*other, int... power>
void add_small(std::vector<Hypothesis>& all, char name, char beside) {
  (all.push_back(gives(kept(fmt::format("small-{}-beside-{}-1e{}", name, beside, power)),
                       read_as<small_beside<small, other, power>>,
                       kept(fmt::format("a {} below about 1e{} of {} is taken for 0: a relative tolerance",
                                        name, power, beside)))),
   ...);
  (all.push_back(of(
       OfSizes::small,
       gives(kept(fmt::format("small-{}-1e{}", name, power)), read_as<small_as_zero<small, power>>,
             kept(fmt::format("a {} below about 1e{} is taken for 0: an absolute epsilon", name, power))))),
   ...);
}

}  // namespace

std::vector<Hypothesis> models_of_coefficients() {
  std::vector<Hypothesis> all{
      gives_one_of("half-b-made-whole", half_b_made_whole,
                   "the answer is right for b/2 rounded down, or cut off, to a whole number: a division of "
                   "integers"),
      gives_one_of("root-beside-zero", root_beside_zero,
                   "where c = 0 the root beside 0 is -b, b/a or -b/(2a), and must be -b/a"),
  };
  add_large_b<12, 10, 9, 8, 7, 6, 5, 4, 3, 2>(all);
  add_small_a_beside_b<-8, -6, -5, -4, -3, -2>(all);
  add_small_a<-12, -10, -9, -8, -7, -6, -5, -4, -3, -2, -1, 0>(all);
  add_nearly_double_roots<-8, -6, -5, -4, -3, -2>(all);
  add_small_discriminants<-16, -15, -14, -13, -12, -10, -9, -8, -7, -6, -5, -4, -3, -2>(all);
  add_terms<Product::direction_squared>(all, "term-of-d-d", "d·d");
  add_terms<Product::way_and_direction>(all, "term-of-l-d", "l·d, l = o - center,");
  add_terms<Product::way_squared>(all, "term-of-l-l", "l·l, l = o - center,");
  add_terms<Product::normal_and_direction>(all, "term-of-n-d", "n·d");
  add_terms<Product::normal_and_origin>(all, "term-of-n-o",
                                        "n·o, o the origin or its way from the plane's point,");
  add_small<&Equation::c, &Equation::b, -8, -6, -5, -4, -3, -2>(all, 'c', 'b');
  add_small<&Equation::b, &Equation::a, -8, -6, -5, -4, -3, -2>(all, 'b', 'a');
  return all;
}

}  // namespace rayproof::diagnosis
