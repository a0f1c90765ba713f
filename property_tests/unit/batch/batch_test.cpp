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

/// Room for the roots of a batch.
template <class T>
struct RootColumns {
  std::vector<T> discriminant, lo, hi;
  explicit RootColumns(std::size_t size) : discriminant(size), lo(size), hi(size) {}
  [[nodiscard]] RootArrays<T> arrays() { return {discriminant, lo, hi}; }
  [[nodiscard]] Roots<T> at(std::size_t lane) const { return {discriminant[lane], lo[lane], hi[lane]}; }
};

/// Six columns of hard rays and a sphere.
template <class T>
struct HardBatch {
  std::vector<T> column[6];
  Sphere<T> sphere;
  RayBatch<T> rays;

  HardBatch(Random& random, std::size_t size) {
    for (auto& numbers : column) numbers = hard_column<T>(random, size);
    sphere = {{hard_number<T>(random), hard_number<T>(random), hard_number<T>(random)},
              std::abs(hard_number<T>(random))};
    rays = {{column[0], column[1], column[2]}, {column[3], column[4], column[5]}};
    if (random.one_in(2)) rays.t_min = hard_number<T>(random);
    if (random.one_in(2)) rays.t_max = hard_number<T>(random);
    if (random.one_in(3)) rays.object_space = object_space(matrix(random));
  }

  static glm::mat<4, 4, T> matrix(Random& random) {
    glm::mat<4, 4, T> whole(T(1));
    for (int i = 0; i < 4; ++i)
      for (int row = 0; row < 3; ++row) whole[i][row] = hard_number<T>(random);
    return whole;
  }

  [[nodiscard]] Ray<T> ray(std::size_t i) const {
    const Ray<T> world{{column[0][i], column[1][i], column[2][i]},
                       {column[3][i], column[4][i], column[5][i]},
                       rays.t_min,
                       rays.t_max};
    return rays.object_space ? to_object(*rays.object_space, world) : world;
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

TEST(Batch, GivesTheScalarRootsOfHardRaysBitForBitAtEveryLengthWithAndWithoutATransform) {
  for_each_kernel<sphere::Topic>(
      []<class Method, class T>(std::type_identity<Method>, T, InstructionSet set) {
        Random random(2);
        for (std::size_t size = 0; size <= longest; ++size) {
          const HardBatch<T> scene(random, size);
          RootColumns<T> roots(size);
          batch_roots<Method>(scene.rays, scene.sphere, roots.arrays(), set);
          for (std::size_t i = 0; i < size; ++i)
            expect_same_roots(Method::roots(scene.ray(i), scene.sphere), roots.at(i), i);
        }
      });
}

TEST(Batch, GivesTheScalarNearestHitOfHardRaysBitForBitAtEveryLength) {
  for_each_kernel<sphere::Topic>([]<class Method, class T>(std::type_identity<Method>, T,
                                                           InstructionSet set) {
    Random random(3);
    for (std::size_t size = 0; size <= longest; ++size) {
      const HardBatch<T> scene(random, size);
      std::vector<T> t(size);
      nearest_hits<Method>(scene.rays, scene.sphere, std::span<T>(t), set);
      for (std::size_t i = 0; i < size; ++i) {
        const Ray<T> ray = scene.ray(i);
        const T scalar = nearest(ray, Method::roots(ray, scene.sphere));
        EXPECT_TRUE(same_bits(scalar, t[i])) << "lane " << i << ": scalar " << scalar << ", batch " << t[i];
      }
    }
  });
}

TEST(Batch, WritesNothingBeyondItsLength) {
  for_each_kernel<sphere::Topic>(
      []<class Method, class T>(std::type_identity<Method>, T, InstructionSet set) {
        Random random(4);
        for (std::size_t size = 0; size <= longest; ++size) {
          const HardBatch<T> scene(random, size);
          std::vector<T> t(size + longest, T(-7));
          nearest_hits<Method>(scene.rays, scene.sphere, std::span<T>(t.data(), size), set);
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
  EXPECT_THROW(
      batch_roots<quadratic::Kahan>(QuadraticBatch<float>{three, three, three}, RootArrays<float>{t, t, {}}),
      std::invalid_argument);
}

}  // namespace

}  // namespace rayproof
