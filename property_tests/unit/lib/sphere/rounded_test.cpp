#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>
#include <rayproof/batch.hpp>
#include <rayproof/sphere/rounded.hpp>

namespace rayproof {
namespace {

using sphere::Rounded;

/// A ray along z that meets the sphere about (0, 0, middle) at middle - r and middle + r.
template <class T>
Roots<T> along_axis(T middle, T r, const Ray<T>& interval = {}) {
  return Rounded::roots(Ray<T>{{0, 0, 0}, {0, 0, 1}, interval.t_min, interval.t_max},
                        Sphere<T>{{0, 0, middle}, r});
}

TEST(RoundedSphere, RoundsTiesToEven) {
  const Roots<float> low = along_axis<float>(0x1p24F, 3);  // 2^24 + 3 lies between 2^24 + 2 and 2^24 + 4
  EXPECT_EQ(low.hi, 0x1p24F + 4);
  EXPECT_EQ(along_axis<float>(0x1p24F, 1).hi, 0x1p24F);
  EXPECT_EQ(along_axis<double>(0x1p53, 3).hi, 0x1p53 + 4);
  EXPECT_EQ(along_axis<double>(0x1p53, 1).hi, 0x1p53);
}

TEST(RoundedSphere, KeepsARootOnItsSideOfTheIntervalsEnds) {
  const Ray<float> until{{}, {}, 0, 0x1p24F};
  const Roots<float> beyond = along_axis<float>(0x1p24F, 1, until);  // 2^24 + 1 would be rounded onto t_max
  EXPECT_GT(beyond.hi, until.t_max);
  const Ray<float> from{{}, {}, 0x1p24F, infinity<float>};
  EXPECT_EQ(along_axis<float>(0x1p24F, 1, from).hi, 0x1p24F);
}

TEST(RoundedSphere, CountsATangentOnceAndTheNextRayTwiceOrNever) {
  const Sphere<float> sphere{{0, 0, 5}, 1};
  const auto discriminant = [&](float y) {
    return Rounded::roots(Ray<float>{{0, y, 0}, {0, 0, 1}}, sphere).discriminant;
  };
  EXPECT_EQ(discriminant(1), 0);
  EXPECT_GT(discriminant(std::nextafter(1.0F, 0.0F)), 0);
  EXPECT_LT(discriminant(std::nextafter(1.0F, 2.0F)), 0);
}

TEST(RoundedSphere, TrustsDoubleOnlyWhereThatIsSure) {
  const Sphere<double> sphere{{0, 0, 5}, 1};
  const auto is_sure = [&](double y) {
    const Ray<double> ray{{0, y, 0}, {0, 0, 1}};
    return rounded_roots(ray, Rounded::enclosed(ray, sphere)).is_sure;
  };
  EXPECT_TRUE(is_sure(0x1p-3));
  EXPECT_TRUE(is_sure(2));
  EXPECT_FALSE(is_sure(1));
  EXPECT_FALSE(is_sure(std::nan("")));
}

/// The map's third is no float: a ray that is rounded into object space first loses what decides.
TEST(RoundedSphere, ComposesATransformExactly) {
  const auto third = object_space(glm::scale(glm::mat4(1), glm::vec3(3, 3, 3)));
  const Sphere<float> sphere{{0, 0, 0}, 1};
  const auto at = [&](float y) {
    return roots_in_world<Rounded>(third, Ray<float>{{0, y, -5}, {0, 0, 1}}, sphere);
  };
  EXPECT_EQ(at(3).discriminant, 0);
  EXPECT_EQ(at(3).lo, 5);
  EXPECT_GT(at(std::nextafter(3.0F, 0.0F)).discriminant, 0);
  EXPECT_LT(at(std::nextafter(3.0F, 4.0F)).discriminant, 0);
  const auto flat = object_space(glm::scale(glm::mat4(1), glm::vec3(1, 1, 0)));
  EXPECT_FALSE(any(Ray<float>{}, roots_in_world<Rounded>(flat, Ray<float>{{0, 0, -5}, {0, 0, 1}}, sphere)));
}

TEST(RoundedSphere, GivesTheScalarHitsInBlocksWithRaysInDoubt) {
  constexpr std::size_t size = 1500;  // several blocks and a part of one
  std::mt19937 bits(1);
  std::uniform_int_distribution<int> whole(-4, 4);  // tangents and ends of the interval are frequent
  std::vector<float> column[6], t(size);
  for (auto& c : column)
    for (std::size_t i = 0; i < size; ++i) c.push_back(static_cast<float>(whole(bits)));
  RayBatch<float> rays{{column[0], column[1], column[2]}, {column[3], column[4], column[5]}, 0, 2};
  const Sphere<float> sphere{{1, 0, 0}, 2};
  for (const bool is_moved : {false, true}) {
    if (is_moved) rays.object_space = object_space(glm::scale(glm::mat4(1), glm::vec3(3, 1, 5)));
    for (const InstructionSet set : available_instruction_sets()) {
      nearest_hits<Rounded>(rays, sphere, t, set);
      for (std::size_t i = 0; i < size; ++i) {
        const Ray<float> ray{
            {column[0][i], column[1][i], column[2][i]}, {column[3][i], column[4][i], column[5][i]}, 0, 2};
        const Roots<float> scalar =
            is_moved ? roots_in_world<Rounded>(*rays.object_space, ray, sphere) : Rounded::roots(ray, sphere);
        ASSERT_EQ(t[i], nearest(ray, scalar)) << "ray " << i << ", " << name_of(set);
      }
    }
  }
}

}  // namespace
}  // namespace rayproof
