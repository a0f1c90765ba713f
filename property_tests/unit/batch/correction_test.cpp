/// \file
/// The nearest hits that are found by correcting plain ones: what the correction is sure of must be right,
/// and it must be sure of nearly every ordinary ray.

#include <rayproof/nearest_hit.hpp>

#include "unit/batch/hard_numbers.hpp"

namespace rayproof {

namespace {

/// What a correction said of many rays.
struct Counted {
  int sure = 0, hits = 0;
};

/// Puts rays and shapes of numbers from `number()` to a method's correction. What it is sure of must be the
/// exact answer, bit for bit.
template <class Method, template <class> class Shape, class T, class Number>
Counted expect_exact_where_sure(Random& random, int count, const Number& number) {
  Counted counted;
  for (int i = 0; i < count; ++i) {
    Shape<T> shape;
    draw_of(shape, random, number);
    const vec3<T> origin = vector_of<T>(number), direction = vector_of<T>(number);
    const Ray<T> ray{origin, direction, random.one_in(4) ? number() : T(0),
                     random.one_in(4) ? number() : infinity<T>};
    const auto [t, is_sure] = corrected_nearest<typename Method::Correction>(ray, shape);
    const T exact = nearest(ray, Method::exact_roots(ray, shape));
    EXPECT_TRUE(same_bits(nearest_hit<Method>(ray, shape), exact)) << "for " << exact;
    if (!is_sure) continue;
    ++counted.sure;
    counted.hits += t < infinity<T> ? 1 : 0;
    EXPECT_TRUE(same_bits(t, exact)) << "sure of " << t << " for " << exact;
  }
  return counted;
}

/// Calls `check(method, topic)` for the shapes whose exact method corrects, and returns how many there are.
template <class Check>
int for_each_correction(const Check& check) {
  int corrections = 0;
  for_each_ray_topic([&]<class Topic>(const Topic* topic) {
    if constexpr (has_correction<typename Topic::Exact>) {
      ++corrections;
      check(std::type_identity<typename Topic::Exact>(), topic);
    }
  });
  return corrections;
}

/// Runs `expect_exact_where_sure` in both precisions on numbers made by `number_of<T>(random)`.
template <class NumberOf, class Expect>
void in_both_precisions(const NumberOf& number_of, const Expect& expect) {
  const int corrections =
      for_each_correction([&]<class Method, template <class> class Shape>(std::type_identity<Method>,
                                                                          const RayTopic<Shape>* /*topic*/) {
        const auto in = [&]<class T>(T) {
          Random random(31);
          const auto number = [&] { return number_of(random, T()); };
          expect(expect_exact_where_sure<Method, Shape, T>(random, 20000, number), 20000);
        };
        in(float());
        in(double());
      });
  EXPECT_EQ(corrections, 5);
}

TEST(Correction, IsSureOfNearlyEveryOrdinaryRay) {
  const auto ordinary = []<class T>(Random& random, T) { return T(3) * draw::symmetric<T>(random); };
  in_both_precisions(ordinary, [](const Counted& counted, int all) {
    EXPECT_GT(counted.sure, all * 99 / 100);
    EXPECT_GT(counted.hits, all / 50);
  });
}

TEST(Correction, IsRightWhereItIsSureOfSmallWholeNumbers) {
  const auto whole = []<class T>(Random& random, T) { return static_cast<T>(random.between(-3, 3)); };
  in_both_precisions(whole, [](const Counted& counted, int all) { EXPECT_GT(counted.sure, all / 10); });
}

TEST(Correction, IsRightWhereItIsSureOfWholeNumbersHalvedManyTimes) {
  const auto scaled = []<class T>(Random& random, T) {
    return std::ldexp(static_cast<T>(random.between(-9, 9)), -random.between(0, 12));
  };
  in_both_precisions(scaled, [](const Counted& counted, int all) { EXPECT_GT(counted.sure, all / 10); });
}

TEST(Correction, IsRightWhereItIsSureOfNumbersOfAnySize) {
  const auto hard = []<class T>(Random& random, T) { return hard_number<T>(random); };
  in_both_precisions(hard, [](const Counted& /*counted*/, int /*all*/) {});
  const auto extreme = []<class T>(Random& random, T) {
    return random.one_in(4) ? draw::bit_pattern<T>(random) : static_cast<T>(random.between(-3, 3));
  };
  in_both_precisions(extreme, [](const Counted& /*counted*/, int /*all*/) {});
}

}  // namespace

}  // namespace rayproof
