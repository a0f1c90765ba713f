#include <gtest/gtest.h>

#include <algorithm>
#include <rayproof/objects/bounds_tree.hpp>

#include "generators/generators.hpp"
#include "oracle/oracle.hpp"
#include "viz/render/hits.hpp"

namespace rayproof::render {
namespace {

TEST(Bounds, NoExactHitOfAnyFamilyIsLeftOut) {
  std::size_t hits = 0;
  for (const Family& family : families()) {
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
      const Case one = family.generate(seed, seed % 2 == 0 ? Precision::float32 : Precision::float64);
      const auto* const question = std::get_if<RayQuestion>(&one.question);
      if (question == nullptr) continue;
      const auto box = bounds_of({question->shape, question->transform, 0});
      const auto answer = std::get<RayAnswer>(oracle::answer(one));
      if (answer.hits.count == 0 || !box) continue;
      ++hits;
      const double entry = objects::RayAgainstBoxes(question->ray).entry(*box, HUGE_VAL);
      EXPECT_LE(entry, beyond_rounding(answer.hits.t[0]))
          << family.topic << '/' << family.name << ' ' << seed;
    }
  }
  EXPECT_GT(hits, 3000U);
}

TEST(Bounds, AUnitSphereHasItsCube) {
  const auto box = bounds_of({Sphere<double>{{1, 2, 3}, 1}, {}, 0});
  ASSERT_TRUE(box);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(box->low[axis], axis);
    EXPECT_GT(box->low[axis], axis - 1e-14);
    EXPECT_GE(box->high[axis], axis + 2);
    EXPECT_LT(box->high[axis], axis + 2 + 1e-14);
  }
}

TEST(Bounds, APlaneAndNumbersNearOverflowHaveNone) {
  EXPECT_FALSE(bounds_of({ImplicitPlane{{0, 1, 0}, 0}, {}, 0}));
  EXPECT_FALSE(bounds_of({Sphere<double>{{0, 0, 0}, 1e200}, {}, 0}));
}

TEST(Bounds, APolygonStandsAsHighAsItsPlaneAwayFromItsVertices) {
  // Its plane is x - y + 2z = 0: near (1, 0) it is half below the vertices.
  const Polygon<double> bent{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}}};
  const RayQuestion question{{{0.99, 0.01, 5}, {0, 0, -1}}, bent, {}};
  const auto answer = std::get<RayAnswer>(oracle::answer({{}, Precision::float64, {}, question}));
  ASSERT_EQ(answer.hits.count, 1U);
  EXPECT_GT(answer.hits.t[0], 5.4);
  const auto box = bounds_of({bent, {}, 0});
  ASSERT_TRUE(box);
  EXPECT_LE(box->low.z, 5 - answer.hits.t[0]);
}

TEST(Bounds, EachObjectNearTheRayIsAskedOnce) {
  RenderScene scene;
  for (int i = 0; i < 100; ++i) scene.objects.push_back({Sphere<double>{{3.0 * i, 0, 0}, 1}, {}, 0});
  scene.objects.push_back({ImplicitPlane{{0, 1, 0}, 0}, {}, 0});
  const auto tree = bounds_tree(scene);
  std::vector<int> asked(scene.objects.size());
  auto meet = [&](ObjectIndex object) {
    ++asked[object];
    return HUGE_VAL;
  };
  tree({{-10, 0, 0}, {1, 0, 0}}, meet);
  EXPECT_EQ(asked, std::vector<int>(101, 1)) << "through all of them";
  tree({{30, 0, 10}, {0, 0, -1}}, meet);
  EXPECT_EQ(std::count(asked.begin(), asked.end(), 2), 2) << "one sphere and the plane";
}

}  // namespace
}  // namespace rayproof::render
