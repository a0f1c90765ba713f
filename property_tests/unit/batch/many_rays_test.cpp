/// \file
/// Many rays among objects: what a list gives for all of them at once is what it gives for each.

#include <rayproof/object_list.hpp>

#include "unit/batch/hard_numbers.hpp"

namespace rayproof {
namespace {

/// Columns of rays of hard numbers, with an interval each.
template <class T>
struct HardRays {
  static constexpr std::size_t size = 600;  // more than are met at once
  std::vector<T> columns[8];

  explicit HardRays(Random& random) {
    for (auto& column : columns) column = hard_column<T>(random, size);
  }
  [[nodiscard]] RayBatch<T> batch() const {
    const auto& [x, y, z, dx, dy, dz, t_min, t_max] = columns;
    return {{x, y, z}, {dx, dy, dz}, T(0), infinity<T>, {}, t_min, t_max};
  }
  [[nodiscard]] Ray<T> ray(std::size_t i) const {
    const auto& [x, y, z, dx, dy, dz, t_min, t_max] = columns;
    return {{x[i], y[i], z[i]}, {dx[i], dy[i], dz[i]}, t_min[i], t_max[i]};
  }
};

/// Adds one hard shape of each topic, and polygons, some under a matrix, where one of them hides another.
template <class List, class T>
void add_some_of_each(List& list, Random& random, T half) {
  const glm::mat<4, 4, T> matrix{{half, 0, 0, 0}, {0, 2, 0, 0}, {0, 1, 1, 0}, {half, 0, -1, 1}};
  const std::size_t topics = for_each_ray_topic([&]<template <class> class Shape>(const RayTopic<Shape>*) {
    Shape<T> shape;
    draw_hard(shape, random);
    list.add(shape);
    draw_hard(shape, random);
    list.add(shape, matrix);
  });
  EXPECT_EQ(topics, 6U);
  const Polygon<T> square{{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
  list.add(square, matrix);
  list.add(square);
  list.add(square);
}

template <class Choice, class T>
void expect_hits_of_each_ray(InstructionSet set) {
  Random random(5);
  const HardRays<T> rays(random);
  ObjectList<T, Choice> list;
  for (int times = 0; times < 3; ++times) add_some_of_each(list, random, T(0.5));
  std::vector<T> t(rays.size);
  std::vector<std::uint32_t> index(rays.size);
  list.nearest(rays.batch(), t, index, set);
  std::size_t hits = 0;
  for (std::size_t i = 0; i < rays.size; ++i) {
    const auto hit = list.nearest(rays.ray(i));
    const bool is_near = hit && hit->t < infinity<T>;
    hits += is_near ? 1 : 0;
    ASSERT_TRUE(same_bits(t[i], is_near ? hit->t : infinity<T>)) << i << ": " << t[i];
    ASSERT_EQ(index[i], is_near ? hit->index : no_object) << i;
  }
  EXPECT_GT(hits, rays.size / 20);
  EXPECT_LT(hits, rays.size);
}

TEST(ManyRays, HaveTheNearestHitsOfEachOnEveryInstructionSet) {
  for (const InstructionSet set : available_instruction_sets()) {
    SCOPED_TRACE(name_of(set));
    expect_hits_of_each_ray<PlainMethods, float>(set);
    expect_hits_of_each_ray<PlainMethods, double>(set);
    expect_hits_of_each_ray<ExactMethods, float>(set);
    expect_hits_of_each_ray<ExactMethods, double>(set);
  }
}

TEST(ManyRays, MeetTheObjectThatWasAddedFirstOfTwoAtOneT) {
  ObjectList<float> list;
  list.add(Sphere<float>{{0, 0, 5}, 1});
  list.add(Box<float>{{-1, -1, 4}, {1, 1, 5}});                    // a later group
  list.add(Triangle<float>{{-1, -1, 4}, {3, -1, 4}, {-1, 3, 4}});  // an earlier one
  const std::vector<float> zero(1), one(1, 1);
  std::vector<float> t(1);
  std::vector<std::uint32_t> index(1);
  list.nearest({{zero, zero, zero}, {zero, zero, one}}, t, index);
  EXPECT_EQ(t[0], 4);
  EXPECT_EQ(index[0], 0U);
}

TEST(ManyRays, AreRefusedWithAMatrixOrArraysOfOtherLengths) {
  const ObjectList<float> list;
  const std::vector<float> two(2);
  std::vector<float> t(2);
  std::vector<std::uint32_t> index(2), short_of_one(1);
  RayBatch<float> rays{{two, two, two}, {two, two, two}};
  EXPECT_THROW(list.nearest(rays, t, short_of_one), std::invalid_argument);
  list.nearest(rays, t, index);
  EXPECT_EQ(t, (std::vector<float>(2, infinity<float>))) << "nothing is there";
  EXPECT_EQ(index, (std::vector<std::uint32_t>(2, no_object)));
  rays.object_space = object_space<float>(glm::mat4(1));
  EXPECT_THROW(list.nearest(rays, t, index), std::invalid_argument);
}

}  // namespace
}  // namespace rayproof
