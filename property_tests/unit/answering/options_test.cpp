#include <gtest/gtest.h>

#include "unit/answering/panel.hpp"

namespace rayproof {
namespace {

/// Right for a unit direction alone.
std::optional<float> unit_sphere_distance(F3 o, F3 d, F3 c, float r) {
  const float b = dot(o - c, d), D = b * b - dot(o - c, o - c) + r * r;
  if (D < 0 || -b - std::sqrt(D) < 0) return {};
  return -b - std::sqrt(D);
}

TEST(option, unit_direction_scales_t_back) {
  EXPECT_EQ(answer_of(sphere_case("-5"), unit_sphere_distance, unit_direction), hit_at("2"));
  EXPECT_EQ(answer_of(sphere_case("-5"), with(unit_sphere_distance, unit_direction)), hit_at("2"));
  EXPECT_NE(answer_of(sphere_case("-5"), unit_sphere_distance), hit_at("2"));
  const auto ends_at_t_max = [](const Ray<float>& ray, const Sphere<float>&) -> std::optional<float> {
    return ray.t_max;
  };
  EXPECT_EQ(answer_of(sphere_case("-5", R"(, "t_max": 0.7)"), ends_at_t_max, unit_direction),
            hit_at("0.699999988079071"))
      << "the scaled interval's end is the case's end";
  const auto nearest_of_ray = [](const Ray<float>& ray, const Sphere<float>& s) {
    return unit_sphere_distance(ray.origin, ray.direction, s.center, s.radius);
  };
  EXPECT_EQ(answer_of(sphere_case("-5"), nearest_of_ray, unit_direction), hit_at("2"))
      << "an endless interval has no end to stand on";
}

TEST(option, no_interval_means_that_hits_outside_are_dropped_and_what_lies_before_t_min_is_not_asked) {
  const auto nearest_of_ray = [](const Ray<float>& ray, const Sphere<float>& s) {
    return unit_sphere_distance(ray.origin, ray.direction, s.center, s.radius);
  };
  EXPECT_EQ(answer_of(sphere_case("-5", R"(, "t_max": 1)"), nearest_of_ray, unit_direction, no_interval),
            miss);
  EXPECT_EQ(answer_of(sphere_case("-5", R"(, "t_min": 2.5)"), nearest_of_ray, unit_direction, no_interval),
            unsupported)
      << "the farther hit is one it does not give";
  const auto plane =
      takes<PointNormalPlane>([](F3 o, F3 d, F3 p, F3 n) { return dot(n, p - o) / dot(n, d); });
  const std::string asked =
      R"({"id": 7, "precision": "float32", "ray": {"origin": [0, 0, 0], "direction": [0, 0, 1], "t_min": 1},
    "shape": {"type": "plane", "point": [0, 0, 2], "normal": [0, 0, 1]}})";
  EXPECT_EQ(answer_of(asked, plane), hit_at("2")) << "a plane has no farther hit";
}

TEST(option, a_number_outside_an_interval_that_the_function_is_given_is_a_wrong_hit) {
  const auto f = [](const Ray<float>& ray, const Sphere<float>& s) {
    return unit_sphere_distance(ray.origin, ray.direction, s.center, s.radius)
        .value_or(std::numeric_limits<float>::quiet_NaN());
  };
  EXPECT_EQ(answer_of(sphere_case("-5", R"(, "t_max": 1)"), f, unit_direction), hit_at("2"));
  EXPECT_EQ(answer_of(sphere_case("-5", R"(, "t_min": 2.5)"), f, unit_direction), hit_at("2"));
  EXPECT_EQ(answer_of(sphere_case("5"), f, unit_direction), miss) << "NaN is a word for a miss";
}

TEST(option, no_interval_does_not_hide_a_hit_behind_the_origin) {
  const auto f = [](F3 o, F3 d, F3, float r, float& t) {
    t = (-o.z - r) / d.z;
    return true;
  };
  EXPECT_EQ(answer_of(sphere_case("5"), f), hit_at("-3"));
  EXPECT_EQ(answer_of(sphere_case("5"), f, whole_line), miss);
}

TEST(option, whole_line_takes_a_negative_t_for_a_hit) {
  const auto f = [](F3 o, F3 d, F3, float r) { return glm::vec2(-o.z - r, -o.z + r) / d.z; };
  const std::string asked = sphere_case("5", R"(, "t_min": "-inf")");
  EXPECT_EQ(answer_of(asked, f), unsupported);
  EXPECT_EQ(answer_of(asked, f, whole_line), hit_at("-3", "-2"));
}

TEST(transformed_cases, are_asked_in_the_objects_space_unless_that_is_excluded) {
  std::string asked = sphere_case("-5");
  asked.insert(asked.size() - 1, R"(, "transform": [[2,0,0,0],[0,2,0,0],[0,0,2,1],[0,0,0,1]])");
  const auto f = [](F3 o, F3 d, F3, float r, float& t, F3& point, F3& normal) {
    t = (-o.z - r) / d.z;
    normal = point = o + t * d;
    return true;
  };
  EXPECT_EQ(answer_of(asked, f),
            R"({"id": 7, "verdict": "hit", "hits": [{"t": 2}], "point": [0, 0, -1], "normal": [0, 0, -1]})"
            "\n");
  EXPECT_EQ(answer_of(asked, f, no_transform), unsupported);
}

}  // namespace
}  // namespace rayproof
