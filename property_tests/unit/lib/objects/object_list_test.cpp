#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <rayproof/rayproof.hpp>

namespace rayproof {
namespace {

Ray<float> along_z(float x = 0) { return Ray{glm::vec3(x, 0, 0), glm::vec3(0, 0, 1)}; }

/// One object of each shape, each a unit before the next along z: at 1, 2, …, 7.
ObjectList<float> one_of_each() {
  ObjectList<float> list;
  list.add(Plane<float>{PlaneForm::implicit, {}, {0, 0, 1}, -7, {}, {}});
  list.add(Triangle<float>{{-1, -1, 6}, {3, -1, 6}, {-1, 3, 6}});
  list.add(Polygon<float>{{{-1, -1, 5}, {1, -1, 5}, {1, 1, 5}, {-1, 1, 5}}});
  list.add(Sphere<float>{{0, 0, 4.25F}, 0.25F});
  list.add(Box<float>{{-1, -1, 3}, {1, 1, 3.5F}});
  list.add(Parallelepiped<float>{{-1, -1, 2}, {{{2, 0, 0}, {0, 2, 0}, {0, 0, 0.5F}}}});
  list.add(Cylinder<float>{1, 1, 0.5F, true}, glm::translate(glm::mat4(1), {0, 0, 1}));
  return list;
}

TEST(ObjectList, FindsTheNearestOfEveryShape) {
  const ObjectList<float> list = one_of_each();
  ASSERT_EQ(list.size(), 7U);
  Ray<float> ray = along_z();
  for (std::size_t index = 7; index-- > 0;) {
    const auto hit = list.nearest(ray);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->index, index);
    EXPECT_EQ(hit->t, 7 - static_cast<float>(index));
    EXPECT_EQ(hit->point, glm::vec3(0, 0, hit->t));
    EXPECT_EQ(std::abs(hit->normal.z), 1) << "each is met at a right angle";
    ray.t_min = hit->t + 0.75F;  // past a solid's far side
  }
  EXPECT_FALSE(list.nearest(ray));
}

TEST(ObjectList, GivesEveryHitInOrder) {
  const auto hits = one_of_each().all(along_z());
  std::vector<float> t;
  for (const auto& hit : hits) t.push_back(hit.t);
  EXPECT_EQ(t, (std::vector<float>{1, 1.5F, 2, 2.5F, 3, 3.5F, 4, 4.5F, 5, 6, 7}));
}

TEST(ObjectList, GivesATangentOnce) {
  ObjectList<float> list;
  list.add(Sphere<float>{{1, 0, 5}, 1});
  const auto hits = list.all(along_z());
  ASSERT_EQ(hits.size(), 1U);
  EXPECT_EQ(hits[0].t, 5);
}

TEST(ObjectList, SaysWhetherAnythingIsHitInTheInterval) {
  const ObjectList<float> list = one_of_each();
  EXPECT_TRUE(list.any(along_z()));
  EXPECT_TRUE(list.any({{0, 0, 0}, {0, 0, 1}, 0, 1})) << "the interval is closed";
  EXPECT_FALSE(list.any({{0, 0, 0}, {0, 0, 1}, 0, 0.5F}));
  EXPECT_FALSE(ObjectList<float>{}.any(along_z()));
}

TEST(ObjectList, TakesTheFirstOfObjectsThatAreHitAtOneT) {
  ObjectList<float> list;
  list.add(Sphere<float>{{0, 0, 9}, 1});
  list.add(Box<float>{{-1, -1, 4}, {1, 1, 5}});
  list.add(Sphere<float>{{0, 0, 5}, 1});
  EXPECT_EQ(list.nearest(along_z())->index, 1U);
}

TEST(ObjectList, HasThePlaceInATriangle) {
  ObjectList<double> list;
  list.add(Triangle<double>{{0, 0, 2}, {4, 0, 2}, {0, 4, 2}});
  const auto hit = list.nearest({{1, 2, 0}, {0, 0, 1}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->u, 0.25);
  EXPECT_EQ(hit->v, 0.5);
}

TEST(ObjectList, BendsTheNormalOfAnObjectUnderItsMatrix) {
  ObjectList<double> list;
  list.add(Sphere<double>{{0, 0, 0}, 1}, glm::scale(glm::dmat4(1), {2, 1, 1}));
  const auto hit = list.nearest({{std::sqrt(2.0), 5, 0}, {0, -1, 0}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point.y, std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(hit->normal.y / hit->normal.x, 2, 1e-14);
}

TEST(ObjectList, MissesWithNaNInTheRayAndUnderASingularMatrix) {
  constexpr float not_given = not_a_number<float>;
  EXPECT_FALSE(one_of_each().nearest({{0, 0, 0}, {0, 0, not_given}}));
  EXPECT_FALSE(one_of_each().any({{not_given, 0, 0}, {0, 0, 1}}));
  EXPECT_TRUE(one_of_each().all({{0, 0, 0}, {0, 0, 1}, not_given, 9}).empty());
  ObjectList<float> list;
  list.add(Sphere<float>{{0, 0, 5}, 1}, glm::mat4(0));
  EXPECT_FALSE(list.nearest(along_z()));
}

TEST(ObjectList, OfExactMethodsIsRightWhereThePlainOnesAreNot) {
  const Sphere<float> ball{{0, 0, 0}, 1};
  ObjectList<float> plain;
  plain.add(ball);
  ObjectList<float, ExactMethods> exact;
  exact.add(ball);
  int plain_right = 0;
  for (int i = 1; i < 64; ++i) {
    const float beside = static_cast<float>(i) / 64;
    const Ray<float> ray{{1000, beside, 0}, {-3, 0, 0}};
    const auto right = static_cast<float>((1000 - std::sqrt(1 - double{beside} * double{beside})) / 3);
    EXPECT_EQ(exact.nearest(ray)->t, right);
    plain_right += plain.nearest(ray)->t == right ? 1 : 0;
  }
  EXPECT_LT(plain_right, 63);
}

}  // namespace
}  // namespace rayproof
