/// \file
/// Leaving surfaces in packs and in batches: bit for bit the scalar origins.

#include <rayproof/arithmetics/pack.hpp>
#include <rayproof/spawn.hpp>
#include <rayproof/spawn/batch.hpp>

#include "unit/batch/hard_numbers.hpp"

namespace rayproof::spawn {

namespace {

template <class T>
struct HitColumns {
  std::vector<T> x, y, z, side;

  HitColumns(Random& random, std::size_t size)
      : x(hard_column<T>(random, size)),
        y(hard_column<T>(random, size)),
        z(hard_column<T>(random, size)),
        side(hard_column<T>(random, size)) {
    for (T& number : side) number = number < 0 ? T(-1) : T(1);
  }
  [[nodiscard]] vec3<T> at(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

template <class T, class Check>
void for_each_surface(const Check& check) {
  check(surface_of(Sphere<T>{{1, 2, 3}, T(0.7)}));
  check(surface_of(Triangle<T>{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}));
  check(surface_of(Plane<T>{PlaneForm::implicit, {}, {1, 2, 3}, 4, {}, {}}));
  check(surface_of(Polygon<T>{{{0, 0, 1}, {1, 0, 0}, {1, 1, 0}}}));
  check(surface_of(Box<T>{{-1, 0, 2}, {T(0.5), 0, 3}}));
  check(
      surface_of(Parallelepiped<T>{{1, 0, 0}, {vec3<T>{1, 0, 0}, vec3<T>{T(0.5), 1, 0}, vec3<T>{0, 1, 2}}}));
  check(surface_of(Cylinder<T>{1, 2, 3, true}));
  check(surface_of(Cylinder<T>{2, 1, 3, false}));
}

template <class T>
glm::mat<4, 4, T> some_map() {
  glm::mat<4, 4, T> map(T(1));
  map[1][0] = T(0.3);
  map[2][2] = T(7);
  map[3] = {T(1), T(-2), T(3), T(1)};
  return map;
}

template <class T>
class LeavingInBatches : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(LeavingInBatches, Precisions);

TYPED_TEST(LeavingInBatches, GivesBitForBitTheScalarOrigins) {
  using T = TypeParam;
  Random random(14);
  for (const std::size_t size : {1U, 5U, 16U, 67U}) {
    const HitColumns<T> hits(random, size);
    for_each_surface<T>([&](const auto& surface) {
      for (const auto& placed : {std::optional<Placement<T>>(), std::optional(placement<T>(some_map<T>()))})
        for (const InstructionSet set : available_instruction_sets()) {
          std::vector<T> x(size), y(size), z(size);
          next_origins<Proven>(surface, {hits.x, hits.y, hits.z}, hits.side, {x, y, z}, placed, set);
          for (std::size_t i = 0; i < size; ++i) {
            SurfacePoint<T> from = placed ? leave(surface, *placed, hits.at(i)) : leave(surface, hits.at(i));
            turn(from, hits.side[i]);
            const vec3<T> scalar = Proven::origin(from);
            EXPECT_TRUE(same_bits(scalar.x, x[i]) && same_bits(scalar.y, y[i]) && same_bits(scalar.z, z[i]))
                << name_of(set) << " lane " << i;
          }
        }
    });
  }
}

/// Every strategy in this file's own packs.
TYPED_TEST(LeavingInBatches, EveryStrategyRunsInPacks) {
  using T = TypeParam;
  using N = Pack<T>;
  Random random(6);
  const HitColumns<T> hits(random, N::size);
  for_each_surface<T>([&](const auto& surface) {
    const SurfacePoint<N> from = leave(
        convert<N>(surface), vec3<N>{N::load(hits.x.data()), N::load(hits.y.data()), N::load(hits.z.data())});
    Strategies::for_each([&]<class Strategy>(std::type_identity<Strategy>) {
      const vec3<N> origin = Strategy::origin(from);
      for (std::size_t i = 0; i < N::size; ++i) {
        const vec3<T> scalar = Strategy::origin(leave(surface, hits.at(i)));
        T lane[3][N::size];
        origin.x.store(lane[0]);
        origin.y.store(lane[1]);
        origin.z.store(lane[2]);
        EXPECT_TRUE(same_bits(scalar.x, lane[0][i]) && same_bits(scalar.y, lane[1][i]) &&
                    same_bits(scalar.z, lane[2][i]))
            << Strategy::name << " lane " << i;
      }
    });
  });
}

TEST(LeavingInBatches, RefusesArraysOfUnlikeLength) {
  std::vector<float> three(3), two(2);
  EXPECT_THROW(next_origins<Proven>(surface_of(Sphere<float>{{0, 0, 0}, 1}), {three, three, three}, two,
                                    {three, three, three}),
               std::invalid_argument);
}

}  // namespace

}  // namespace rayproof::spawn
