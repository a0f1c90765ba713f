#include "subjects/among_neighbours.hpp"
#include "unit/batch/hard_numbers.hpp"

namespace rayproof {

namespace {

constexpr int problems = 500;

TEST(AmongNeighbours, AnEquationHasItsScalarRootsWhateverLiesBesideIt) {
  for_each_kernel<quadratic::Topic>(
      []<class Method, class T>(std::type_identity<Method>, T, InstructionSet set) {
        Random random(5);
        for (int i = 0; i < problems; ++i) {
          const Quadratic<T> q{hard_number<T>(random), hard_number<T>(random), hard_number<T>(random)};
          const Roots<T> scalar = Method::roots(q);
          const Roots<T> batch = batch::roots_among_neighbours<Method>(q, set);
          EXPECT_TRUE(same_bits(scalar.lo, batch.lo) && same_bits(scalar.hi, batch.hi));
          EXPECT_TRUE(same_bits(scalar.discriminant, batch.discriminant));
        }
      });
}

TEST(AmongNeighbours, ARayHasItsScalarRootsWhateverLiesBesideIt) {
  for_each_kernel<sphere::Topic>([]<class Method, class T>(std::type_identity<Method>, T,
                                                           InstructionSet set) {
    Random random(6);
    const auto vector = [&] { return vec3<T>{draw::symmetric<T>(random), draw::symmetric<T>(random), T(1)}; };
    for (int i = 0; i < problems; ++i) {
      const vec3<T> origin = vector(), beside = vector(), target = vector(), center = vector();
      const Ray<T> ray{T(3) * origin, target - T(2) * beside};
      const Sphere<T> sphere{center, T(1)};
      const Roots<T> scalar = Method::roots(ray, sphere);
      const Roots<T> batch = batch::roots_among_neighbours<Method>(ray, sphere, {}, set);
      EXPECT_TRUE(same_bits(scalar.lo, batch.lo) && same_bits(scalar.hi, batch.hi));
    }
  });
}

TEST(AmongNeighbours, ProblemsReachEveryLane) {
  constexpr std::size_t lanes = batch::mixed_lanes<sphere::Centred>;
  std::vector<int> reached(lanes);
  for (int i = 0; i < 2000; ++i)
    ++reached.at(batch::MixedLanes<float, 3, lanes>({static_cast<float>(i), 1.0F, 2.0F}).lane);
  for (const int times : reached) EXPECT_GT(times, 0);
}

TEST(InstructionSets, BeginWithTheBaselineAndEndWithThePreferredOne) {
  const auto& available = available_instruction_sets();
  ASSERT_FALSE(available.empty());
  EXPECT_EQ(available.front(), InstructionSet::baseline);
  if (std::getenv("RAYPROOF_ISA") == nullptr) {
    EXPECT_EQ(preferred_instruction_set(), available.back());
  } else {
    EXPECT_EQ(name_of(preferred_instruction_set()), std::getenv("RAYPROOF_ISA"));
  }
}

}  // namespace

}  // namespace rayproof
