/// \file
/// What roots.hpp says of the roots of every method, on cases of every family in its domain: what no answer
/// shows.

#include <gtest/gtest.h>

#include <cmath>

#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "properties/trial.hpp"
#include "subjects/our_subject.hpp"

namespace rayproof {
namespace {

constexpr std::uint64_t cases_of_each = 60;

/// Asks all methods for roots but the points in polygons, which have none.
template <class Expect>
void for_all_roots(const Expect& expect) {
  for (const Family& family : families())
    Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
      if constexpr (!std::is_same_v<Topic, point_in_polygon::Topic>)
        if (family.topic == Topic::name)
          Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
            const Subject& subject = *find_subject(std::string(Topic::name) + '/' + Method::name);
            for (const Precision precision : {Precision::float32, Precision::float64})
              for (std::uint64_t seed = 0; seed < cases_of_each; ++seed) {
                const Case one = family.generate(seed, precision);
                if (!Trial(subject, one).in_domain()) continue;
                in_precision(precision,
                             [&]<class T>(T) { expect(Method(), solve_in<Topic, Method, T>(one), one); });
              }
          });
    });
}

TEST(RootsOfEveryMethod, AreNaNWhereTheDiscriminantIsNegativeOrNaN) {
  for_all_roots([]<class Method>(Method, const auto& roots, const Case& one) {
    if (roots.discriminant >= 0) return;
    EXPECT_TRUE(std::isnan(roots.lo) && std::isnan(roots.hi)) << Method::name << ": " << write_case(one);
  });
}

TEST(RootsOfEveryMethod, AreOneNumberWhereTheDiscriminantIsZero) {
  for_all_roots([]<class Method>(Method, const auto& roots, const Case& one) {
    if (roots.discriminant != 0 || !std::isfinite(roots.lo)) return;  // a naive method divides by a = 0
    EXPECT_EQ(roots.lo, roots.hi) << Method::name << ": " << write_case(one);
  });
}

TEST(RootsOfEveryMethod, AscendWhereTheDiscriminantIsPositive) {
  for_all_roots([]<class Method>(Method, const auto& roots, const Case& one) {
    EXPECT_FALSE(roots.hi < roots.lo) << Method::name << ": " << write_case(one);
  });
}

TEST(RootsOfEveryMethod, AreNumbersWhereASoundOneSaysThatThereAreSome) {
  for_all_roots([]<class Method>(Method, const auto& roots, const Case& one) {
    const auto* q = std::get_if<Quadratic<double>>(&one.question);
    if (Method::contract.standing != Standing::sound || !(roots.discriminant >= 0) ||
        (q != nullptr && q->a == 0))
      return;
    EXPECT_FALSE(std::isnan(roots.lo) && std::isnan(roots.hi)) << Method::name << ": " << write_case(one);
  });
}

}  // namespace
}  // namespace rayproof
