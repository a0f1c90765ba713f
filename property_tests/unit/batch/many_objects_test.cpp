#include <rayproof/object_list.hpp>

#include "unit/batch/hard_numbers.hpp"

namespace rayproof {

namespace {

constexpr std::size_t most_objects = 67;

template <class T>
Ray<T> hard_ray(Random& random) {
  Ray<T> ray{hard_vector<T>(random), hard_vector<T>(random)};
  if (random.one_in(2)) ray.t_min = hard_number<T>(random);
  if (random.one_in(2)) ray.t_max = hard_number<T>(random);
  return ray;
}

template <class T>
glm::mat<4, 4, T> hard_matrix(Random& random) {
  glm::mat<4, 4, T> matrix(T(1));
  for (int i = 0; i < 4; ++i)
    for (int row = 0; row < 3; ++row) matrix[i][row] = hard_number<T>(random);
  return matrix;
}

/// What lists give for rays that are asked about every object in turn.
template <class Choice, class T>
void expect_answers_of_one_by_one(const ObjectList<T, Choice>& list, const Ray<T>& ray) {
  const auto in_turn = [&](const auto& meet) { list.for_each(meet); };
  const auto expected = objects::nearest_of<Choice>(ray, in_turn);
  const auto hit = list.nearest(ray);
  ASSERT_EQ(hit.has_value(), expected.has_value());
  EXPECT_EQ(list.any(ray), objects::any_of<Choice>(ray, in_turn));
  if (!hit) return;
  EXPECT_EQ(hit->index, expected->index);
  EXPECT_TRUE(same_bits(hit->t, expected->t)) << hit->t << ", one by one " << expected->t;
  EXPECT_TRUE(same_bits(hit->u, expected->u) && same_bits(hit->v, expected->v));
}

/// Lists of up to `most_objects` hard shapes, some of them under hard matrices.
template <class Choice, class T, template <class> class Shape>
void expect_the_same_of_hard_shapes(const RayTopic<Shape>* /*topic*/) {
  Random random(3);
  ObjectList<T, Choice> list;
  while (list.size() < most_objects) {
    Shape<T> shape;
    draw_hard(shape, random);
    if (random.one_in(4)) {
      list.add(shape, hard_matrix<T>(random));
    } else {
      list.add(shape);
    }
    for (int rays = 0; rays < 6; ++rays) expect_answers_of_one_by_one(list, hard_ray<T>(random));
  }
}

TEST(ManyObjects, AreMetInPacksBitForBitAsOneByOne) {
  Topics::for_each([]<class Topic>(std::type_identity<Topic>) {
    if constexpr (has_columns<Topic>) {
      SCOPED_TRACE(Topic::name);
      const Topic* const topic = nullptr;
      expect_the_same_of_hard_shapes<PlainMethods, float>(topic);
      expect_the_same_of_hard_shapes<PlainMethods, double>(topic);
      expect_the_same_of_hard_shapes<ExactMethods, float>(topic);
      expect_the_same_of_hard_shapes<ExactMethods, double>(topic);
    }
  });
}

/// Every instruction set's kernel of a method: what it gives for hard shapes. The sum of what it is in doubt
/// of is returned.
template <class Method, class T, template <class> class Shape>
std::size_t expect_scalar_hits(const RayTopic<Shape>* /*topic*/, InstructionSet set) {
  using Many = objects::Many<RayProblem<Shape, T>>;
  constexpr std::size_t size = 4 * objects::lanes;
  Random random(4);
  std::vector<Shape<T>> shapes(size);
  std::vector<T> numbers(Many::shape_numbers * size);
  Many in{numbers.data(), size / objects::lanes, {}};
  std::size_t in_doubt = 0;
  for (int rays = 0; rays < 200; ++rays) {
    in.ray = hard_ray<T>(random);
    for (std::size_t lane = 0; lane < size; ++lane) {
      draw_hard(shapes[lane], random);
      T* to = &numbers[lane / objects::lanes * objects::lanes * Many::shape_numbers + lane % objects::lanes];
      for (const T& number : std::bit_cast<std::array<T, Many::shape_numbers>>(shapes[lane])) {
        *to = number;
        to += objects::lanes;
      }
    }
    T t[size];
    const auto found =
        std::get<objects::ObjectKernel<Method, RayProblem<Shape, T>>>(objects::kernel_table(set)).meet(in, t);
    T least = infinity<T>;
    std::size_t nans = 0;
    for (std::size_t lane = 0; lane < size; ++lane) {
      nans += std::isnan(t[lane]) ? 1 : 0;
      if (std::isnan(t[lane])) continue;
      const T scalar = nearest(in.ray, Method::roots(in.ray, shapes[lane]));
      EXPECT_TRUE(same_bits(scalar, t[lane])) << "lane " << lane << ": " << t[lane] << ", scalar " << scalar;
      least = std::min(least, t[lane]);
    }
    EXPECT_EQ(found.t, least);
    EXPECT_EQ(found.is_in_doubt, nans > 0);
    in_doubt += nans;
  }
  return in_doubt;
}

TEST(ManyObjects, HaveTheSameHitsOnEveryInstructionSet) {
  Topics::for_each([]<class Topic>(std::type_identity<Topic>) {
    if constexpr (has_columns<Topic>) {
      const Topic* const topic = nullptr;
      for (const InstructionSet set : available_instruction_sets()) {
        SCOPED_TRACE(std::string(Topic::name) + " on " + std::string(name_of(set)));
        const std::size_t all = std::size_t{200} * 4 * objects::lanes;
        EXPECT_LT((expect_scalar_hits<typename Topic::Plain, float>(topic, set)), all / 50);
        EXPECT_LT((expect_scalar_hits<typename Topic::Plain, double>(topic, set)), all / 50);
        const std::size_t in_doubt = expect_scalar_hits<typename Topic::Exact, float>(topic, set) +
                                     expect_scalar_hits<typename Topic::Exact, double>(topic, set);
        EXPECT_GT(in_doubt, 0U) << "a hard number leaves a quick phase in doubt";
        EXPECT_LT(in_doubt, 2 * all) << "but not always";
      }
    }
  });
}

TEST(ManyObjects, AreFoundBlockAfterBlock) {
  ObjectList<float> list;
  for (int i = 0; i < 2000; ++i) list.add(Sphere<float>{{0, 0, static_cast<float>(4000 - i)}, 0.25F});
  const Ray ray{glm::vec3(0, 0, 0), glm::vec3(0, 0, 1)};
  const auto hit = list.nearest(ray);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->index, 1999U);
  EXPECT_EQ(hit->t, 2000.75F);
  EXPECT_TRUE(list.any(ray));
  EXPECT_FALSE(list.any(Ray{glm::vec3(0, 0, 0), glm::vec3(0, 0, 1), 0.0F, 2000.0F}));
  EXPECT_EQ(list.all(ray).size(), 4000U);
}

}  // namespace

}  // namespace rayproof
