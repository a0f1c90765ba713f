/// \file
/// Causes that are known by a mark of the answers, where no model foresees these.

#include <gtest/gtest.h>

#include "oracle/oracle.hpp"
#include "properties/claims/answers.hpp"
#include "unit/diagnosis/clinic.hpp"
#include "unit/diagnosis/faulty/faulty.hpp"

namespace rayproof::faulty {
namespace {

using Roots = QuadraticAnswer<double>;

/// The exact roots, changed where there are as many as `count`.
template <class DoChange>
Answer with_roots_changed(const Case& one, std::size_t count, DoChange&& change) {
  Answer answer = oracle::answer(one);
  auto& roots = std::get<Roots>(answer);
  if (roots.count == count) change(roots.roots);
  return answer;
}

Answer roots_too_far_apart(const Case& one) {
  return with_roots_changed(one, 2, [](auto& x) {
    const double middle = (x[0] + x[1]) / 2, half = 0.7 * (x[1] - x[0]);
    x = {middle - half, middle + half};
  });
}

Answer roots_moved(const Case& one) {
  return with_roots_changed(one, 2, [](auto& x) {
    const double way = 0.3 * std::max(std::abs(x[0]), std::abs(x[1]));
    x = {x[0] + way, x[1] + way};
  });
}

Answer one_root_moved(const Case& one) {
  return with_roots_changed(one, 2, [](auto& x) { x[1] += 0.7 * std::abs(x[1]) + 0.1 * (x[1] - x[0]); });
}

Answer double_root_moved(const Case& one) {
  Answer answer = oracle::answer(one);
  auto& roots = std::get<Roots>(answer);
  if (roots.kind == RootKind::twice) roots.roots[0] = 3 * roots.roots[0] + 1;
  return answer;
}

Answer plus_root_first(const Case& one) {
  Answer answer = oracle::answer(one);
  auto& roots = std::get<Roots>(answer);
  if (std::get<Quadratic<double>>(one.question).a > 0 && roots.count == 2)
    std::swap(roots.roots[0], roots.roots[1]);
  return answer;
}

/// q times a number, and c / q for the other root.
Answer q_scaled(const Case& one) {
  Answer answer = oracle::answer(one);
  auto& [kind, count, x] = std::get<Roots>(answer);
  if (count != 2) return answer;
  x = {1.7 * x[0], x[1] / 1.7};
  std::ranges::sort(x);
  return answer;
}

/// Wrong on polygons whose normal is 0 in a coordinate: hits are halved.
Answer halved_where_upright(const Case& one) {
  Answer answer = oracle::answer(one);
  const auto& asked = std::get<RayQuestion>(one.question);
  const auto& vertices = std::get<Polygon<double>>(asked.shape).vertices;
  glm::dvec3 normal(0);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    normal += glm::cross(vertices[i] - vertices[0], vertices[(i + 1) % vertices.size()] - vertices[0]);
  const bool is_upright = normal.x == 0 || normal.y == 0 || normal.z == 0;
  auto& hits = std::get<RayAnswer>(answer).hits;
  std::get<RayAnswer>(answer).point.reset();
  if (is_upright && hits.count > 0) hits.t[0] = std::sqrt(std::abs(hits.t[0])) / 3 + 0.1;
  return answer;
}

Answer hit_at_minus_one() {
  RayAnswer answer;
  answer.hits.push_back(-1);
  return answer;
}
Answer all_at_minus_one(const Case& /*one*/) { return hit_at_minus_one(); }
Answer misses_at_minus_one(const Case& one) {
  const Answer exact = oracle::answer(one);
  return finds_something(exact) ? exact : hit_at_minus_one();
}

/// A verdict alone.
Answer always_hit(const Case& /*one*/) {
  RayAnswer answer;
  answer.verdict_only = true;
  answer.hits.push_back(0);
  return answer;
}

/// The normal of a box's entry has its sign from the side of min on which the ray's origin lies.
Answer normal_by_side_of_origin(const Case& one) {
  Answer answer = oracle::answer(one);
  auto& hits = std::get<RayAnswer>(answer);
  const auto& [ray, shape, transform] = std::get<RayQuestion>(one.question);
  if (!hits.normal || transform || glm::dot(*hits.normal, ray.direction) >= 0) return answer;
  const auto& box = std::get<Box<double>>(shape);
  for (int axis = 0; axis < 3; ++axis)
    if ((*hits.normal)[axis] != 0) (*hits.normal)[axis] = ray.origin[axis] < box.min[axis] ? -1 : 1;
  return answer;
}

/// Roots 1 and c / a, in that order, where a + b + c = 0; 0 and -b / a where c = 0.
template <bool is_of_zero>
Answer with_known_root_first(const Case& one) {
  const auto& [a, b, c] = std::get<Quadratic<double>>(one.question);
  if (a == 0 || (is_of_zero ? c : a + b + c) != 0) return oracle::answer(one);
  return Roots{RootKind::two, 2, {is_of_zero ? 0.0 : 1.0, is_of_zero ? -b / a : c / a}};
}

/// The textbook's roots, but for D, which a float holds.
Answer roots_of_discriminant_in_float(const Case& one) {
  const auto& [a, b, c] = std::get<Quadratic<double>>(one.question);
  const double D = static_cast<float>(b * b - 4 * a * c);
  if (a == 0 || !(D > 0)) return oracle::answer(one);
  Roots roots{RootKind::two, 2, {(-b - std::sqrt(D)) / (2 * a), (-b + std::sqrt(D)) / (2 * a)}};
  std::ranges::sort(roots.roots);
  return roots;
}

struct Marked {
  const char* topic;
  const char* property;
  const char* cause;
  Answer (*code)(const Case&);
};

TEST(DiagnosisByMarks, NamesWhatNoModelForesees) {
  for (const auto& [topic, property, cause, code] : std::initializer_list<Marked>{
           {"quadratic", "residual", "distance-of-roots-wrong", roots_too_far_apart},
           {"quadratic", "residual", "middle-of-roots-wrong", roots_moved},
           {"quadratic", "residual", "one-root-wrong", one_root_moved},
           {"quadratic", "residual", "double-root-wrong", double_root_moved},
           {"quadratic", "residual", "q-wrong", q_scaled},
           {"quadratic", "ascending", "plus-root-first", plus_root_first},
           {"quadratic", "ascending", "fixed-place-of-1", with_known_root_first<false>},
           {"quadratic", "ascending", "fixed-place-of-0", with_known_root_first<true>},
           {"quadratic", "residual", "discriminant-in-float", roots_of_discriminant_in_float},
           {"sphere", "verdict", "all-at-minus-one", all_at_minus_one},
           {"box", "verdict", "misses-at-minus-one", misses_at_minus_one},
           {"box", "verdict", "always-hits", always_hit},
           {"box", "normal", "normal-signed-by-origin", normal_by_side_of_origin},
           {"polygon", "residual", "wrong-where-upright", halved_where_upright}}) {
    const std::string found =
        in_words(faults_of(subject_of(topic, code), *find_property(property), Precision::float64, 60));
    EXPECT_TRUE(found.starts_with(std::string(cause) + " ")) << cause << ", found: " << found;
  }
}

}  // namespace
}  // namespace rayproof::faulty
