/// \file
/// The methods `rounded` on whole numbers with a few among them that double-doubles do not hold: their quick
/// phase must leave to exact arithmetic what it cannot know.

#include <rayproof/formulas/bounded_roots.hpp>
#include <rayproof/nearest_hit.hpp>

#include "unit/batch/hard_numbers.hpp"

namespace rayproof {

namespace {

/// A small whole number, or a power of two beyond 2^±64, or near it.
template <class T>
T whole_or_extreme(Random& random) {
  if (!random.one_in(10)) return static_cast<T>(random.between(-3, 3));
  const int exponent = random.between(60, 90);
  return std::ldexp(random.one_in(2) ? T(1) : T(-1), random.one_in(3) ? exponent : -exponent);
}

template <class T>
void expect_same(const Roots<T>& quick, const Roots<T>& exact) {
  EXPECT_EQ(quick.discriminant < 0, exact.discriminant < 0);
  EXPECT_TRUE(same_bits(quick.lo, exact.lo)) << quick.lo << " for " << exact.lo;
  EXPECT_TRUE(same_bits(quick.hi, exact.hi)) << quick.hi << " for " << exact.hi;
}

/// The number of hits.
template <class Method, template <class> class Shape, class T>
int expect_exact_answers() {
  Random random(21);
  const auto number = [&] { return whole_or_extreme<T>(random); };
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    Shape<T> shape;
    draw_of(shape, random, number);
    const vec3<T> origin = vector_of<T>(number), direction = vector_of<T>(number);
    const Ray<T> ray{origin, direction, -infinity<T>};
    const Roots<T> exact = Method::exact_roots(ray, shape);
    expect_same<T>(Method::roots(ray, shape), exact);
    hits += exact.discriminant < 0 ? 0 : 1;

    // One in four begins, or ends, at one of these numbers, which many a hit is.
    const Ray<T> ahead{origin, direction, random.one_in(4) ? number() : T(0),
                       random.one_in(4) ? number() : infinity<T>};
    const T t = nearest(ahead, Method::exact_roots(ahead, shape));
    EXPECT_TRUE(same_bits(quick_hit<Method>(ahead, shape), t)) << "for " << t;

    const glm::mat<4, 4, T> enlarged{{2, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, 2, 0}, {0, 0, 0, 1}};
    const auto space = object_space(enlarged);
    expect_same<T>(roots_in_world<Method>(space, ray, shape), met_exactly<Method>(space, ray, shape));
  }
  return hits;
}

/// The shape of a topic, for both precisions.
template <class Topic, template <class> class Shape>
void expect_exact_answers_of(const RayTopic<Shape>* /*topic*/) {
  EXPECT_GT((expect_exact_answers<typename Topic::Exact, Shape, float>()), 100);
  EXPECT_GT((expect_exact_answers<typename Topic::Exact, Shape, double>()), 100);
}

TEST(QuickPhase, LeavesNumbersThatItCannotHoldToExactArithmetic) {
  const std::size_t shapes =
      for_each_ray_topic([]<class Topic>(const Topic* topic) { expect_exact_answers_of<Topic>(topic); });
  EXPECT_EQ(shapes, 6U);
}

}  // namespace

}  // namespace rayproof
