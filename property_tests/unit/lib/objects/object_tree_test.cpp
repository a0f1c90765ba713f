#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <random>
#include <rayproof/rayproof.hpp>
#if __has_include(<embree3/rtcore.h>)
#include <rayproof/objects/embree_tree.hpp>
#endif

namespace rayproof {
namespace {

/// Random numbers from -1 to 1.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  float operator()() { return number_(random_); }
  glm::vec3 vector() { return {(*this)(), (*this)(), (*this)()}; }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<float> number_{-1, 1};
};

/// Objects of every shape, small ones in a cube of side 20, every third under a matrix.
template <class Choice>
ObjectList<float, Choice> crowd(int count) {
  Draw draw(7);
  ObjectList<float, Choice> list;
  const auto put = [&](const auto& shape, int i) {
    glm::mat4 matrix = glm::translate(glm::mat4(1), 10.0F * draw.vector());
    if (i % 3 == 0) matrix = glm::rotate(matrix, draw(), {1, 2, 3});
    list.add(shape, matrix);
  };
  for (int i = 0; i < count; ++i) {
    const glm::vec3 a = 10.0F * draw.vector(), b = a + draw.vector(), c = a + draw.vector();
    list.add(Triangle<float>{a, b, c});
    list.add(Sphere<float>{10.0F * draw.vector(), 0.5F});
    list.add(Box<float>{a, a + 0.5F});
    put(Sphere<float>{{0, 0, 0}, 0.5F}, i);
    put(Cylinder<float>{0.5F, 0.25F, 1, true}, i);
    put(Polygon<float>{{{0, 0, 0}, {1, 0, 0.1F}, {0.3F, 0.4F, 0}, {0, 1, 0}}}, i);
    put(Parallelepiped<float>{{0, 0, 0}, {{{1, 0, 0}, {0.5F, 1, 0}, {0, 0.5F, 0.5F}}}}, i);
  }
  list.add(Plane<float>{PlaneForm::implicit, {}, {0, 0, 1}, 9, {}, {}});
  return list;
}

template <class T>
void expect_same(const std::optional<HitRecord<T>>& one, const std::optional<HitRecord<T>>& other) {
  ASSERT_EQ(one.has_value(), other.has_value());
  if (!one) return;
  EXPECT_EQ(one->t, other->t);
  EXPECT_EQ(one->index, other->index);
  EXPECT_EQ(one->point, other->point);
  EXPECT_EQ(one->normal, other->normal);
}

/// Asks the list and its tree of rays from inside, from near by and from afar.
template <class Choice, class Search>
void expect_same_answers(int count, int ray_count) {
  const auto list = crowd<Choice>(count);
  const ObjectTree<float, Choice, Search> tree(list);
  ASSERT_EQ(tree.size(), list.size());
  Draw draw(3);
  std::size_t hits = 0;
  for (int i = 0; i < ray_count; ++i) {
    const float away = i % 5 == 0 ? 1e4F : 15;
    const glm::vec3 origin = away * draw.vector();
    const float length = i % 7 == 0 ? 1e-15F : i % 7 == 1 ? 1e10F : 1;
    Ray<float> ray{origin, length * (10.0F * draw.vector() - origin)};
    if (i % 3 == 0) ray.t_max = 1 / length;
    if (i % 3 == 1) ray.t_min = 0.9F / length;
    if (i % 4 == 0) ray.t_min = -infinity<float>;
    const auto nearest = list.nearest(ray);
    expect_same(nearest, tree.nearest(ray));
    EXPECT_EQ(list.any(ray), tree.any(ray));
    EXPECT_EQ(list.any(ray), nearest.has_value());
    const auto all = list.all(ray), found = tree.all(ray);
    ASSERT_EQ(all.size(), found.size());
    for (std::size_t k = 0; k < all.size(); ++k) expect_same(std::optional(all[k]), std::optional(found[k]));
    hits += all.size();
  }
  EXPECT_GE(hits, static_cast<std::size_t>(count > 0 ? ray_count / 2 : 0));
}

TEST(ObjectTree, GivesTheListsAnswersByPlainMethods) {
  expect_same_answers<PlainMethods, objects::BoundsTree>(60, 1500);
}
TEST(ObjectTree, GivesTheListsAnswersByExactMethods) {
  expect_same_answers<ExactMethods, objects::BoundsTree>(12, 400);
}
#if __has_include(<embree3/rtcore.h>)
TEST(ObjectTree, GivesTheListsAnswersByEmbree) {
  expect_same_answers<PlainMethods, objects::EmbreeTree>(60, 1500);
  expect_same_answers<ExactMethods, objects::EmbreeTree>(12, 400);
  expect_same_answers<PlainMethods, objects::EmbreeTree>(0, 9);
}
#endif

TEST(ObjectTree, OfNothingMeetsNothing) {
  const ObjectTree tree(ObjectList<double>{});
  EXPECT_FALSE(tree.nearest({{0, 0, 0}, {0, 0, 1}}));
  EXPECT_FALSE(tree.any({{0, 0, 0}, {0, 0, 1}}));
  EXPECT_TRUE(tree.all({{0, 0, 0}, {0, 0, 1}}).empty());
}

TEST(ObjectTree, AsksEveryRayOfWhatHasNoBox) {
  ObjectList<double> list;
  list.add(Plane<double>{PlaneForm::implicit, {}, {0, 0, 1}, -7, {}, {}});
  list.add(Sphere<double>{{0, 0, 1e170}, 1e160});
  const ObjectTree tree(std::move(list));
  EXPECT_EQ(tree.nearest({{0, 0, 0}, {0, 0, 1}})->t, 7);
  EXPECT_EQ(tree.nearest({{3, 4, 8}, {0, 0, -1}})->t, 1);
  EXPECT_FALSE(tree.any({{0, 0, 0}, {1, 0, 0}}));
}

TEST(ObjectTree, MissesWithNaNInTheRayAndUnderASingularMatrix) {
  constexpr float not_given = not_a_number<float>;
  const ObjectTree tree(crowd<PlainMethods>(9));
  EXPECT_FALSE(tree.nearest({{0, 0, 0}, {0, 0, not_given}}));
  EXPECT_FALSE(tree.any({{not_given, 0, 0}, {0, 0, 1}}));
  EXPECT_TRUE(tree.all({{0, 0, 0}, {0, 0, 1}, not_given, 9}).empty());
  ObjectList<float> flat;
  for (int i = 0; i < 9; ++i) flat.add(Sphere<float>{{0, 0, 5}, 1}, glm::mat4(0));
  EXPECT_FALSE(ObjectTree(flat).nearest({{0, 0, 0}, {0, 0, 1}}));
}

TEST(ObjectTree, MissesAPolygonWithoutVerticesAmongOthers) {
  ObjectList<float> list;
  list.add(Polygon<float>{});
  for (int i = 0; i < 9; ++i) list.add(Sphere<float>{{0, 0, 5}, 1});
  EXPECT_EQ(ObjectTree(list).nearest({{0, 0, 0}, {0, 0, 1}})->index, 1U);
}

TEST(ObjectTree, TakesTheFirstOfManyThatAreHitAtOneT) {
  ObjectList<float> list;
  for (int i = 0; i < 100; ++i) list.add(Sphere<float>{{0, 0, 9 - static_cast<float>(i % 2)}, 1});
  const ObjectTree tree(std::move(list));
  EXPECT_EQ(tree.nearest({{0, 0, 0}, {0, 0, 1}})->index, 1U);
  EXPECT_EQ(tree.all({{0, 0, 0}, {0, 0, 1}}).size(), 200U);
}

}  // namespace
}  // namespace rayproof
