#include <rayproof/batch.hpp>

#include "unit/batch/hard_numbers.hpp"

namespace rayproof {

namespace {

constexpr std::size_t longest = 67;

template <class T>
void expect_same_roots(const Roots<T>& scalar, const Roots<T>& batch, std::size_t lane) {
  EXPECT_TRUE(same_bits(scalar.discriminant, batch.discriminant) && same_bits(scalar.lo, batch.lo) &&
              same_bits(scalar.hi, batch.hi))
      << "lane " << lane << ": scalar " << scalar.discriminant << ' ' << scalar.lo << ' ' << scalar.hi
      << ", batch " << batch.discriminant << ' ' << batch.lo << ' ' << batch.hi;
}
template <class T>
void expect_same_roots(const FlatHit<T>& scalar, const FlatHit<T>& batch, std::size_t lane) {
  expect_same_roots<T>(static_cast<const Roots<T>&>(scalar), batch, lane);
  EXPECT_TRUE(same_bits(scalar.u, batch.u) && same_bits(scalar.v, batch.v))
      << "lane " << lane << ": scalar u, v " << scalar.u << ' ' << scalar.v << ", batch " << batch.u << ' '
      << batch.v;
}

/// Room for the roots of a batch.
template <class T>
struct RootColumns {
  std::vector<T> discriminant, lo, hi, u, v;
  explicit RootColumns(std::size_t size) : discriminant(size), lo(size), hi(size), u(size), v(size) {}
  [[nodiscard]] RootArrays<T> arrays() { return {discriminant, lo, hi, u, v}; }
  [[nodiscard]] FlatHit<T> at(std::size_t i) const { return {{discriminant[i], lo[i], hi[i]}, u[i], v[i]}; }
};

/// Columns of hard rays, each with its own interval or one of all, and a shape.
template <class T, template <class> class Shape>
struct HardBatch {
  std::vector<T> column[8];
  Shape<T> shape;
  RayBatch<T> rays;

  HardBatch(Random& random, std::size_t size) {
    for (auto& numbers : column) numbers = hard_column<T>(random, size);
    draw_hard(shape, random);
    rays = {{column[0], column[1], column[2]}, {column[3], column[4], column[5]}};
    if (random.one_in(2)) rays.t_min = hard_number<T>(random);
    if (random.one_in(2)) rays.t_max = hard_number<T>(random);
    if (random.one_in(2)) rays.each_t_min = column[6];
    if (random.one_in(2)) rays.each_t_max = column[7];
    if (random.one_in(3)) rays.object_space = object_space(matrix(random));
  }

  static glm::mat<4, 4, T> matrix(Random& random) {
    glm::mat<4, 4, T> whole(T(1));
    for (int i = 0; i < 4; ++i)
      for (int row = 0; row < 3; ++row) whole[i][row] = hard_number<T>(random);
    return whole;
  }

  [[nodiscard]] Ray<T> ray(std::size_t i) const {
    return {{column[0][i], column[1][i], column[2][i]},
            {column[3][i], column[4][i], column[5][i]},
            rays.each_t_min.empty() ? rays.t_min : column[6][i],
            rays.each_t_max.empty() ? rays.t_max : column[7][i]};
  }
  template <class Method>
  [[nodiscard]] auto roots(std::size_t i) const {
    return rays.object_space ? roots_in_world<Method>(*rays.object_space, ray(i), shape)
                             : Method::roots(ray(i), shape);
  }
};

TEST(Batch, GivesTheScalarRootsOfHardEquationsBitForBitAtEveryLength) {
  for_each_kernel<quadratic::Topic>(
      []<class Method, class T>(std::type_identity<Method>, T, InstructionSet set) {
        Random random(1);
        for (std::size_t size = 0; size <= longest; ++size) {
          const std::vector<T> a = hard_column<T>(random, size);
          const std::vector<T> b = hard_column<T>(random, size);
          const std::vector<T> c = hard_column<T>(random, size);
          RootColumns<T> roots(size);
          batch_roots<Method>(QuadraticBatch<T>{a, b, c}, roots.arrays(), set);
          for (std::size_t i = 0; i < size; ++i)
            expect_same_roots(Method::roots(Quadratic<T>{a[i], b[i], c[i]}), roots.at(i), i);
        }
      });
}

/// Roots and nearest hits of hard rays with a hard shape, by kernel and one by one, at many lengths.
template <class Method, class T, template <class> class Shape>
void expect_scalar_answers_of(const RayTopic<Shape>* /*topic*/, InstructionSet set) {
  Random random(2);
  for (std::size_t size = 0; size <= longest; ++size) {
    const HardBatch<T, Shape> scene(random, size);
    RootColumns<T> roots(size);
    batch_roots<Method>(scene.rays, scene.shape, roots.arrays(), set);
    std::vector<T> t(size);
    nearest_hits<Method>(scene.rays, scene.shape, std::span<T>(t), set);
    for (std::size_t i = 0; i < size; ++i) {
      const Ray<T> ray = scene.ray(i);
      const auto scalar = scene.template roots<Method>(i);
      expect_same_roots(scalar, roots.at(i), i);
      EXPECT_TRUE(same_bits(nearest(ray, scalar), t[i])) << "lane " << i << ": batch " << t[i];
    }
  }
}

TEST(Batch, GivesTheScalarAnswersOfHardRaysBitForBitAtEveryLengthWithAndWithoutATransform) {
  std::size_t shapes = 0;
  Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
    if constexpr (is_batched<Topic> && !std::is_same_v<Topic, quadratic::Topic>) {
      ++shapes;
      for_each_kernel<Topic>([]<class Method, class T>(std::type_identity<Method>, T, InstructionSet set) {
        expect_scalar_answers_of<Method, T>(static_cast<const Topic*>(nullptr), set);
      });
    }
  });
  EXPECT_EQ(shapes, 6U);
}

TEST(Batch, LeavesOutTheColumnsThatNobodyGives) {
  Random random(5);
  const HardBatch<float, Triangle> scene(random, longest);
  RootColumns<float> all(longest), some(longest);
  batch_roots<triangle::Woop>(scene.rays, scene.shape, all.arrays());
  batch_roots<triangle::Woop>(scene.rays, scene.shape, {some.discriminant, some.lo, some.hi});
  for (std::size_t i = 0; i < longest; ++i)
    expect_same_roots<float>(static_cast<const Roots<float>&>(all.at(i)), some.at(i), i);
}

TEST(Batch, TakesRaysIntoObjectSpaceBlockAfterBlock) {
  Random random(6);
  constexpr std::size_t size = 1000;  // several blocks and a part of one
  HardBatch<double, Sphere> scene(random, size);
  scene.rays.object_space = object_space(HardBatch<double, Sphere>::matrix(random));
  std::vector<double> t(size);
  nearest_hits<sphere::Centred>(scene.rays, scene.shape, std::span<double>(t));
  for (std::size_t i = 0; i < size; ++i) {
    const auto scalar = scene.roots<sphere::Centred>(i);
    EXPECT_TRUE(same_bits(nearest(scene.ray(i), scalar), t[i])) << "ray " << i;
  }
}

TEST(Batch, WritesNothingBeyondItsLength) {
  for_each_kernel<sphere::Topic>(
      []<class Method, class T>(std::type_identity<Method>, T, InstructionSet set) {
        Random random(4);
        for (std::size_t size = 0; size <= longest; ++size) {
          const HardBatch<T, Sphere> scene(random, size);
          std::vector<T> t(size + longest, T(-7));
          nearest_hits<Method>(scene.rays, scene.shape, std::span<T>(t.data(), size), set);
          for (std::size_t i = size; i < t.size(); ++i)
            EXPECT_EQ(t[i], T(-7)) << "at " << i << " of " << size;
        }
      });
}

TEST(Batch, GivesNoHitWhereANumberOfTheRayIsNaN) {
  for_each_kernel<sphere::Topic>([]<class Method, class T>(std::type_identity<Method>, T,
                                                           InstructionSet set) {
    constexpr std::size_t size = 6;
    const std::vector<T> numbers[6] = {std::vector<T>(size, T(0)),  std::vector<T>(size, T(0)),
                                       std::vector<T>(size, T(-5)), std::vector<T>(size, T(0)),
                                       std::vector<T>(size, T(0)),  std::vector<T>(size, T(1))};
    for (std::size_t broken = 0; broken < 6; ++broken) {
      std::vector<T> column[6];
      for (std::size_t c = 0; c < 6; ++c) column[c] = numbers[c];
      column[broken].assign(size, std::numeric_limits<T>::quiet_NaN());
      std::vector<T> t(size);
      nearest_hits<Method>(RayBatch<T>{{column[0], column[1], column[2]}, {column[3], column[4], column[5]}},
                           Sphere<T>{{0, 0, 0}, 1}, std::span<T>(t), set);
      for (const T hit : t) EXPECT_EQ(hit, infinity<T>);
    }
  });
}

TEST(Batch, RefusesArraysOfUnlikeLengths) {
  const std::vector<float> three(3);
  const std::vector<float> four(4);
  std::vector<float> t(3);
  EXPECT_THROW(nearest_hits<sphere::Centred>(RayBatch<float>{{three, three, three}, {three, four, three}},
                                             Sphere<float>{{0, 0, 0}, 1}, std::span<float>(t)),
               std::invalid_argument);
  const RayBatch<float> with_ends{
      .origin = {three, three, three}, .direction = {three, three, three}, .each_t_max = four};
  EXPECT_THROW(nearest_hits<sphere::Centred>(with_ends, Sphere<float>{{0, 0, 0}, 1}, std::span<float>(t)),
               std::invalid_argument);
  EXPECT_THROW(
      batch_roots<quadratic::Kahan>(QuadraticBatch<float>{three, three, three}, RootArrays<float>{t, t, {}}),
      std::invalid_argument);
}

}  // namespace

}  // namespace rayproof
