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
    const auto corrected = corrected_nearest<typename Method::Correction>(ray, shape);
    const T t = corrected.answer;
    const T exact = nearest(ray, Method::exact_roots(ray, shape));
    EXPECT_TRUE(same_bits(nearest_hit<Method>(ray, shape), exact)) << "for " << exact;
    if (!corrected.is_sure) continue;
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

/// A number that is the next, or the next but one, on either side, or the same.
template <class T>
T neighbour_of(T x, Random& random) {
  const T end = random.one_in(2) ? infinity<T> : -infinity<T>;
  for (int steps = random.between(0, 2); steps > 0; --steps) x = std::nextafter(x, end);
  return x;
}

/// Rays whose interval begins or ends at the lower or the upper root, or beside it.
template <class Method, template <class> class Shape, class T>
void expect_exact_at_ends(const RayTopic<Shape>* /*topic*/) {
  Random random(47);
  const auto number = [&] { return T(3) * draw::symmetric<T>(random); };
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    Shape<T> shape;
    draw_of(shape, random, number);
    const vec3<T> origin = vector_of<T>(number), direction = vector_of<T>(number);
    Ray<T> ray{origin, direction, -infinity<T>, infinity<T>};
    const Roots<T> roots = Method::exact_roots(ray, shape);
    if (!(roots.discriminant >= 0)) continue;
    ++hits;
    const T t = neighbour_of(random.one_in(2) ? roots.lo : roots.hi, random);
    (random.one_in(2) ? ray.t_min : ray.t_max) = t;
    const T exact = nearest(ray, Method::exact_roots(ray, shape));
    const auto corrected = corrected_nearest<typename Method::Correction>(ray, shape);
    if (corrected.is_sure) {
      EXPECT_TRUE(same_bits(corrected.answer, exact)) << corrected.answer << " for " << exact;
    }
  }
  EXPECT_GT(hits, 100);
}

TEST(Correction, IsSureOfNothingFalseWhereTheIntervalEndsBesideAHit) {
  const int corrections = for_each_correction([]<class Method, template <class> class Shape>(
                                                  std::type_identity<Method>, const RayTopic<Shape>* topic) {
    expect_exact_at_ends<Method, Shape, float>(topic);
    expect_exact_at_ends<Method, Shape, double>(topic);
  });
  EXPECT_EQ(corrections, 5);
}

/// Rays enough for several blocks and a part of one, met with one shape by packs.
template <class Method, template <class> class Shape, class T>
void expect_exact_in_packs(InstructionSet set) {
  Random random(17);
  const auto number = [&] { return static_cast<T>(random.between(-64, 64)) / 16; };
  constexpr std::size_t size = 1300;
  for (int i = 0; i < 8; ++i) {
    Shape<T> shape;
    draw_of(shape, random, number);
    std::vector<T> column[6], t(size);
    for (auto& c : column)
      for (std::size_t k = 0; k < size; ++k) c.push_back(number());
    const RayBatch<T> rays{{column[0], column[1], column[2]}, {column[3], column[4], column[5]}};
    nearest_hits<Method>(rays, shape, std::span<T>(t), set);
    for (std::size_t k = 0; k < size; ++k) {
      const Ray<T> ray{{column[0][k], column[1][k], column[2][k]},
                       {column[3][k], column[4][k], column[5][k]}};
      EXPECT_TRUE(same_bits(t[k], nearest(ray, Method::exact_roots(ray, shape)))) << "ray " << k;
    }
  }
}

TEST(Correction, InPacksLeavesTheExactAnswerBlockAfterBlock) {
  const int corrections =
      for_each_correction([]<class Method, template <class> class Shape>(std::type_identity<Method>,
                                                                         const RayTopic<Shape>* /*topic*/) {
        for (const InstructionSet set : available_instruction_sets()) {
          SCOPED_TRACE(std::string(name_of(set)));
          expect_exact_in_packs<Method, Shape, float>(set);
          expect_exact_in_packs<Method, Shape, double>(set);
        }
      });
  EXPECT_EQ(corrections, 5);
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

/// Triangles whose sides are of products near the greatest number, where one overflows and another would take
/// it back.
TEST(Correction, IsSureOfNothingFalseWhereATrianglesSidesOverflow) {
  using T = float;
  Random random(53);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const int most = std::numeric_limits<T>::max_exponent, of_shape = random.between(-most / 4, most / 4);
    const int of_direction = std::min(most - 2 * of_shape - random.between(4, 12), most - 8);
    const auto number = [&](int exponent) {
      return std::ldexp(static_cast<T>(random.between(-9, 9)), exponent);
    };
    Triangle<T> triangle;
    draw_of(triangle, random, [&] { return number(of_shape); });
    const Ray<T> ray{vector_of<T>([&] { return number(of_shape); }),
                     vector_of<T>([&] { return number(of_direction); })};
    const auto corrected = corrected_nearest<triangle::Correction>(ray, triangle);
    const T exact = nearest(ray, triangle::Rounded::exact_roots(ray, triangle));
    hits += exact < infinity<T> ? 1 : 0;
    if (corrected.is_sure) {
      EXPECT_TRUE(same_bits(corrected.answer, exact)) << corrected.answer << " for " << exact;
    }
  }
  EXPECT_GT(hits, 100);
}

}  // namespace

}  // namespace rayproof
