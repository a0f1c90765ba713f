/// \file
/// Faults in limits, units and digits of t.

#include <fmt/format.h>

#include <algorithm>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/curved/near_sphere.hpp"
#include "properties/diagnosis/models/curved/quadratic.hpp"
#include "properties/diagnosis/models/first_hit/points.hpp"
#include "properties/diagnosis/models/hits/digits.hpp"
#include "properties/diagnosis/models/hits/factor.hpp"
#include "properties/diagnosis/models/hits/hits.hpp"
#include "properties/diagnosis/models/hits/interval.hpp"
#include "properties/diagnosis/models/hits/wrong_interval.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {

namespace {

/// What is nearer than that is taken to be at 0; that t = 0 is left out alone would be less.
Hypothesis epsilon(std::string_view name, Predict predict, std::string_view sentence) {
  return shown_by(has_first_hit_before_origin, of(OfSizes::small, gives(name, predict, sentence)));
}

/// That a ray is missed is foreseen by culling, too: a t of the wrong sign must be given once.
template <Quantity sign>
Hypothesis wrong_sign(std::string_view name, std::string_view sentence) {
  const auto finds_another = [](const Case& one, const Answer& exact) {
    return std::ranges::any_of(line_scaled_by<sign>(one, exact), finds_something);
  };
  return shown_by(finds_another, gives(name, line_scaled_by<sign>, sentence));
}

template <int... power>
void add_epsilons(std::vector<Hypothesis>& all) {
  (all.push_back(
       epsilon(kept(fmt::format("epsilon-1e{}", power)), drops_below<power>,
               kept(fmt::format("hits with t below about 1e{} are left out: an absolute epsilon", power)))),
   ...);
}

/// A limit of lengths: in a smaller scene nothing lies beyond it.
Hypothesis limit(int power, Predict predict) {
  Hypothesis made =
      gives(kept(fmt::format("limit-1e{}", power)), predict,
            kept(fmt::format("hits with t beyond about 1e{} are left out: a fixed largest distance", power)));
  made.confirmed_by = "smaller-scene";
  return of(OfSizes::limit, made);
}

template <int... power>
void add_limits(std::vector<Hypothesis>& all) {
  (all.push_back(limit(power, drops_beyond<power>)), ...);
}

/// The same of what is compared: the distance of a sphere's centre, and not t.
template <int... power>
void add_far_centres(std::vector<Hypothesis>& all) {
  const auto add = [&](int tens, Predict predict, bool (*shows_more)(const Case&, const Answer&)) {
    Hypothesis made = shown_by(shows_more, limit(tens, predict));
    made.name = kept(fmt::format("far-centre-1e{}", tens));
    made.sentence = kept(fmt::format(
        "a sphere whose centre is farther from the origin than about 1e{} is missed: a fixed limit", tens));
    all.push_back(made);
  };
  (add(power, far_centre_missed<power>, has_hit_within<power>), ...);
}

/// That small numbers are made 0 would be an epsilon.
template <int decimals>
Hypothesis few_decimals() {
  return shown_by(
      loses_decimals<decimals>,
      of(OfSizes::small,
         gives_to_most(kept(fmt::format("decimals-{}", decimals)), rounded_to_decimals<decimals>,
                       kept(fmt::format("every number is rounded to a multiple of 1e-{}: the code "
                                        "prints too few decimals, or rounds",
                                        decimals)))));
}

template <int... decimals>
void add_decimals(std::vector<Hypothesis>& all) {
  (all.push_back(few_decimals<decimals>()), ...);
}

/// Few decimals of barycentric coordinates.
template <int... decimals>
void add_decimals_of_weights(std::vector<Hypothesis>& all) {
  (all.push_back(gives(
       kept(fmt::format("weights-decimals-{}", decimals)), weights_to_decimals<decimals>,
       kept(fmt::format("the barycentric coordinates are rounded to multiples of 1e-{}: the code prints too "
                        "few decimals, or rounds",
                        decimals)),
       gross, Aspect::coordinates)),
   ...);
}

/// A point that is off shows it, too.
Hypothesis of_all_numbers(Hypothesis mark) {
  mark.is_throughout = true;
  return mark;
}

/// An approximation that all goes through.
Hypothesis approximated_throughout() {
  Hypothesis made =
      shows("approximate-throughout", is_off_by_a_share,
            "every hit is off by a small share of the scene, and verdicts are wrong by no more: something is "
            "approximated, a square root, a curve by straight pieces, or a search that ends too soon");
  made.least_share = 80;
  made.admits = 60;  // what is approximated may be exact here and there, as a cap beside a side
  made.is_vague = true;
  made.is_throughout = true;
  return made;
}

/// An iteration that stops at a fixed length: any loss of digits is near to it in some cases.
Hypothesis stop(int power, Recognise recognise) {
  // Those that it meets exactly, on flat faces, may fail by rounding.
  return of_share(80, shows(kept(fmt::format("stops-at-1e{}", power)), recognise,
                            kept(fmt::format("every hit is right to about 1e{} in length, whatever the size "
                                             "of the scene: an iteration stops there",
                                             power))));
}

template <int... power>
void add_stops(std::vector<Hypothesis>& all) {
  (all.push_back(stop(power, is_right_to_length<power>)), ...);
}

}  // namespace

std::vector<Hypothesis> models_of_limits() {
  std::vector<Hypothesis> all{
      epsilon("type-epsilon", drops_below_epsilon,
              "hits with t below the machine epsilon of the type, 1.2e-7 or 2.2e-16, are left out: it is no "
              "length"),
  };
  all.front().is_one_of_many = true;  // it is t that is compared, or the distance
  all.front().differs_by_precision = true;
  add_epsilons<-15, -12, -10, -9, -8, -7, -6, -5, -4, -3, -2, -1, 0>(all);
  add_limits<30, 20, 16, 15, 12, 10, 9, 8, 7, 6, 5, 4, 3, 2>(all);
  add_far_centres<12, 10, 9, 8, 7, 6, 5, 4, 3, 2>(all);
  return all;
}

std::vector<Hypothesis> models_of_numbers() {
  std::vector<Hypothesis> all{
      gives(
          "t-as-distance", scaled_by<length_of_direction>,
          "t is right divided by the direction's length: it is a distance, not in lengths of the direction"),
      gives("t-as-object-distance", scaled_by<length_in_object>,
            "t is right divided by the length of the direction in object space: that direction was made a "
            "unit vector"),
      strictly(gives_one_of(
          "infinity-as-zero", infinity_as_zero,
          "the answer is right for 0 where t_max is infinite, or either end is: infinity is read as 0")),
      gives(
          "t-times-stretch", scaled_by<stretch_of_direction>,
          "t is right divided by how much longer the direction is in object space: it was made a unit vector "
          "there, and t is not of the given one"),
      gives("t-over-length", scaled_by<length_of_direction, -1>,
            "t is right times the direction's length: it was divided by |d| once too often"),
      gives("t-times-square", scaled_by<square_of_direction>,
            "t is right divided by d·d: the division by d·d is missing"),
      gives("t-over-square", scaled_by<square_of_direction, -1>,
            "t is right times d·d: it was divided by d·d once too often"),
      following("inverse-transform",
                gives_to_all("negated", scaled_by<minus_one>, "every number is right with the other sign")),
      gives_to_most("absolute", absolute,
                    "t is right without its sign: hits behind the origin are taken for hits before it"),
      gives_to_all("reciprocal", reciprocal, "every number is 1/t: numerator and denominator are exchanged"),
      gives_to_most(
          "rounded-down", rounded_down,
          "every number is rounded down to a whole one: a division of integers, or an integer holds it"),
      gives_to_most("rounded-to-whole", rounded_to_whole,
                    "every number is rounded to the nearest whole one: an integer holds it"),
      gives_to_most("cut-off", cut_off, "every number is cut off to a whole one: an integer holds it"),
      gives("times-slope", scaled_by<slope>,
            "t is right divided by n·d: the division by the normal times the direction is missing"),
      gives("times-minus-slope", scaled_by<minus_slope>,
            "t is right divided by -n·d: the division by the determinant is missing"),
      wrong_sign<sign_of_slope>(
          "sign-of-slope",
          "t has the wrong sign where the surface is seen from the front: |n·d| is in the denominator"),
      wrong_sign<minus_sign_of_slope>(
          "minus-sign-of-slope",
          "t has the wrong sign where the surface is seen from behind: |n·d| is in the denominator"),
      gives("distance-to-plane", scaled_by<distance_per_t>,
            "t is the origin's distance from the plane: it was measured along the normal, and must be along "
            "the "
            "direction"),
      gives("doubled", scaled_by<two>,
            "every number is twice the right one: a factor 2 in the denominator is missing"),
      gives("halved", scaled_by<two, -1>,
            "every number is half the right one: a factor 2 too many in the denominator"),
      gives("over-constant", scaled_by<constant_of_sphere, -1>,
            "t is right times c = |o - center|² - r²: the denominator is 2ac and must be 2a"),
      gives("over-radius", scaled_by<radius_of_sphere, -1>,
            "t is right times the radius: it is measured in radii"),
      gives("times-radius", scaled_by<radius_of_sphere>, "t is right divided by the radius"),
      gives("times-a", scaled_by<coefficient_a>,
            "every root is right divided by a: the division by a is missing"),
      gives("times-a-squared", scaled_by<square_of_a>,
            "every root is right divided by a²: it is multiplied by a and must be divided, as (-b ± √D) / 2 "
            "* a is read"),
      gives("over-a", scaled_by<coefficient_a, -1>,
            "every root is right times a: a stands once too often in the denominator"),
      gives("over-c", scaled_by<coefficient_c, -1>,
            "every root is right times c: the denominator is 2ac and must be 2a"),
      gives("times-normal", scaled_by<length_of_normal>,
            "t is right divided by the normal's length: a division by it is missing"),
      gives("over-normal", scaled_by<length_of_normal, -1>,
            "t is right times the normal's length: the normal is taken for a unit vector"),
      misses_zero("double-root-missed", double_root_missed, "a double root is taken for none"),
      gives("discriminant-sign-lost", discriminant_without_sign,
            "roots are reported where D < 0: the root of |D| was taken"),
      gives("positive-roots-alone", positive_roots_alone, "negative roots are left out"),
      gives("real-part", real_part,
            "the real part of the complex roots is given where there is no real root"),
      gives("linear-root-negated", linear_root_negated,
            "where a = 0 the root has the wrong sign: it is -c/b"),
  };
  add_decimals<1, 2, 3, 4, 5, 6>(all);
  all.push_back(strictly(shows("always-hits", always_hits,
                               "every case tried hits, says the subject, also where there is nothing")));
  return all;
}

std::vector<Hypothesis> models_of_digits() {
  std::vector<Hypothesis> all{
      of(OfSizes::type,
         shows("computes-in-half", is_of_half,
               "every number is one of float16: the code computes in half precision", rounding)),
      of(OfSizes::type,
         shows("computes-in-float", is_of_float,
               "every number is one of float32, though the case is of float64: the code computes in float",
               rounding)),
      shows("whole-numbers", has_whole_numbers,
            "every number is a whole one: it is cut off or rounded to an integer"),
      shows("prints-six-decimals", has_six_decimals,
            "no number has more than six decimals: the code prints too few of them, or rounds", rounding),
      of_all_numbers(shows("prints-six-digits", has_six_digits,
                           "no number has more than six digits: the code prints too few of them", rounding)),
      of(OfSizes::type,
         shows("float-on-the-way", is_right_to_float,
               "right to about seven digits: a float on the way, though the case is of float64", rounding)),
      shows("float-in-coordinates", coordinates_right_to_float,
            "the barycentric coordinates are right to about seven digits: a float on the way to them, though "
            "the case is of float64",
            rounding, Aspect::coordinates),
      shows(
          "float-in-point", point_right_to_float,
          "the point is right to about seven digits: a float on the way to it, though the case is of float64",
          rounding, Aspect::point),
      shows("approximate", is_approximate,
            "every number is right to two to five digits and no better: something is approximated, a square "
            "root or a reciprocal",
            rounding),
      shows("approximate-root", has_approximate_root,
            "the hits are off by a small share of the chord between them: the square root is approximated",
            rounding),
  };
  add_stops<-6, -5, -4, -3, -2, -1>(all);
  all.push_back(approximated_throughout());
  add_decimals_of_weights<1, 2, 3, 4>(all);
  return all;
}

}  // namespace rayproof::diagnosis
