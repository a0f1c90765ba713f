/// \file
/// Correct rounding under transforms: the quick phase, alone and in packs, beside the exact one.

#include <rayproof/arithmetics/pack.hpp>
#include <rayproof/batch.hpp>
#include <rayproof/formulas/bounded_roots.hpp>

#include "unit/batch/hard_numbers.hpp"

namespace rayproof {

namespace {

template <class T>
vec3<T> usual_vector(Random& random) {
  return {draw::symmetric<T>(random), draw::symmetric<T>(random), draw::symmetric<T>(random)};
}

/// A shape of about the size 1 about the origin.
template <class T>
void draw_usual(Sphere<T>& sphere, Random& random) {
  sphere = {usual_vector<T>(random), T(1.5)};
}
template <class T>
void draw_usual(Plane<T>& plane, Random& random) {
  draw_hard(plane, random);
}
template <class T>
void draw_usual(Triangle<T>& triangle, Random& random) {
  triangle = {usual_vector<T>(random), usual_vector<T>(random), usual_vector<T>(random)};
}
template <class T>
void draw_usual(Box<T>& box, Random& random) {
  box = {{-1, -1, -1}, vec3<T>(1) + T(0.5) * usual_vector<T>(random)};
}
template <class T>
void draw_usual(Parallelepiped<T>& shape, Random& random) {
  shape.corner = usual_vector<T>(random);
  for (auto& edge : shape.edges) edge = usual_vector<T>(random);
}
template <class T>
void draw_usual(Cylinder<T>& cylinder, Random& random) {
  cylinder = {T(0.5) + std::abs(draw::symmetric<T>(random)), 1, T(1.25), random.one_in(2)};
}

/// Any regular matrix, or one that scales along the axes.
template <class T>
glm::mat<4, 4, T> usual_matrix(Random& random) {
  glm::mat<4, 4, T> matrix(1);
  for (int i = 0; i < 3; ++i) matrix[i] = glm::vec<4, T>(usual_vector<T>(random), 0);
  if (random.one_in(4)) {
    for (int i = 0; i < 3; ++i)
      for (int row = 0; row < 3; ++row) matrix[i][row] = i == row ? static_cast<T>(i + 2) : 0;
  }
  matrix[3] = glm::vec<4, T>(usual_vector<T>(random), 1);
  return matrix;
}

constexpr std::size_t ray_count = 67;

/// Rays at the place where an object is.
template <class T>
struct UsualRays {
  std::vector<T> column[8];
  RayBatch<T> rays;

  UsualRays(Random& random, const glm::mat<4, 4, T>& matrix) {
    for (std::size_t i = 0; i < ray_count; ++i) {
      const vec3<T> o = T(4) * usual_vector<T>(random);
      const vec3<T> d = vec3<T>(matrix * glm::vec<4, T>(usual_vector<T>(random), 1)) - o;
      const T numbers[8] = {o.x, o.y, o.z, d.x, d.y, d.z, T(0.25), random.one_in(2) ? T(1) : T(8)};
      for (int c = 0; c < 8; ++c) column[c].push_back(numbers[c]);
    }
    rays = {{column[0], column[1], column[2]}, {column[3], column[4], column[5]}};
    rays.each_t_min = column[6];
    rays.each_t_max = column[7];
    rays.object_space = object_space(matrix);
  }
  [[nodiscard]] Ray<T> at(std::size_t i) const {
    const auto& c = column;
    return {{c[0][i], c[1][i], c[2][i]}, {c[3][i], c[4][i], c[5][i]}, c[6][i], c[7][i]};
  }
};

template <class Method, class T, template <class> class Shape>
bool is_sure(const ObjectSpace<T>& space, const Ray<T>& ray, const Shape<T>& shape) {
  using B = Bounded<WiderThan<T>>;
  const Ray<B> seen = to_object(bounded_space(space), convert<B>(ray));
  const auto wide = Method::enclosed_in_space(seen, convert<B>(shape));
  return rounded_roots(convert<double>(ray), wide).is_sure;
}

/// The share of rays whose quick phase is in doubt.
template <class Method, class T, template <class> class Shape>
double expect_exact_answers(const RayTopic<Shape>* /*topic*/) {
  Random random(11);
  int in_doubt = 0;
  constexpr int scenes = 60;
  for (int scene = 0; scene < scenes; ++scene) {
    const auto matrix = usual_matrix<T>(random);
    const UsualRays<T> batch(random, matrix);
    Shape<T> shape;
    draw_usual(shape, random);
    const auto& space = *batch.rays.object_space;
    for (const InstructionSet set : available_instruction_sets()) {
      std::vector<T> t(ray_count);
      nearest_hits<Method>(batch.rays, shape, t, set);
      for (std::size_t i = 0; i < ray_count; ++i) {
        const Ray<T> ray = batch.at(i);
        const auto exact = met_exactly<Method>(space, ray, shape);
        EXPECT_TRUE(same_bits(t[i], nearest(ray, exact))) << t[i] << " on " << name_of(set);
        const auto alone = roots_in_world<Method>(space, ray, shape);
        EXPECT_EQ(alone.discriminant < 0, exact.discriminant < 0);
        EXPECT_TRUE(same_bits(alone.lo, exact.lo) && same_bits(alone.hi, exact.hi));
        if (set == InstructionSet::baseline) in_doubt += is_sure<Method>(space, ray, shape) ? 0 : 1;
      }
    }
  }
  return static_cast<double>(in_doubt) / (scenes * ray_count);
}

TEST(InWorld, BatchesAndSingleRaysAreMetAsWithNothingRounded) {
  const std::size_t shapes = for_each_ray_topic([]<class Topic>(const Topic* topic) {
    const double most = std::is_same_v<Topic, plane::Topic> ? 0.6 : 0.02;  // planes of hard numbers
    EXPECT_LT((expect_exact_answers<typename Topic::Exact, float>(topic)), most);
    EXPECT_LT((expect_exact_answers<typename Topic::Exact, double>(topic)), most);
  });
  EXPECT_EQ(shapes, 6U);
}

/// Numbers with errors, in packs and lane by lane.
TEST(InWorld, BoundsInPacksAreThoseOfEachLane) {
  using N = Pack<double>;
  Random random(12);
  const auto drawn = [&](double(&lanes)[N::size]) {
    for (double& lane : lanes) lane = hard_number<double>(random);
    return N::load(lanes);
  };
  for (int i = 0; i < 500; ++i) {
    double x[N::size], x_error[N::size], y[N::size], y_error[N::size];
    const auto tiny = [&](double(&lanes)[N::size]) {
      for (double& lane : lanes)
        lane = random.one_in(3) ? 0 : 0x1p-40 * std::abs(draw::symmetric<double>(random));
      return N::load(lanes);
    };
    const auto a = Bounded<N>::of(drawn(x), tiny(x_error)), b = Bounded<N>::of(drawn(y), tiny(y_error));
    const auto check = [&](const auto& function) {
      double value[N::size], error[N::size];
      const Bounded<N> packs = function(a, b);
      packs.value.store(value);
      packs.error.store(error);
      for (std::size_t lane = 0; lane < N::size; ++lane) {
        const Bounded<double> alone = function(Bounded<double>::of(x[lane], x_error[lane]),
                                               Bounded<double>::of(y[lane], y_error[lane]));
        EXPECT_TRUE(same_bits(alone.value, value[lane]) && same_bits(alone.error, error[lane]))
            << alone.value << " +- " << alone.error << ", in a pack " << value[lane] << " +- " << error[lane];
      }
    };
    check([](const auto& p, const auto& q) { return p + q; });
    check([](const auto& p, const auto& q) { return p - q; });
    check([](const auto& p, const auto& q) { return p * q; });
    check([](const auto& p, const auto& q) { return p / q; });
    check([](const auto& p, const auto& q) { return sqrt(p) + q; });
    check([](const auto& p, const auto& q) { return fma(p, q, p); });
    check([](const auto& p, const auto& q) { return copysign(p, q); });
    check([](const auto& p, const auto& q) { return select(p < q || p == -q, abs(p), q); });
  }
}

}  // namespace

}  // namespace rayproof
