#include <gtest/gtest.h>

#include <glm/vec4.hpp>

#include "unit/answering/panel.hpp"

namespace rayproof {
namespace {

using glm::vec2, glm::vec4;

/// Both t of the line and a sphere; NaN for none.
vec2 both(F3 o, F3 d, F3 c, float r) {
  const F3 l = o - c;
  const float a = dot(d, d), b = dot(l, d), root = std::sqrt(b * b - a * (dot(l, l) - r * r));
  return {(-b - root) / a, (-b + root) / a};
}

struct Hit {
  float t;
  F3 point, normal;
};

TEST(result_of_a_function, may_be_an_optional_t) {
  const auto f = [](F3 o, F3 d, F3 c, float r) -> std::optional<float> {
    const float t = both(o, d, c, r).x;
    return t > 0 ? std::optional(t) : std::nullopt;
  };
  EXPECT_EQ(answer_of(sphere_case("-5"), f), hit_at("2"));
  EXPECT_EQ(answer_of(sphere_case("5"), f), miss);
}

TEST(result_of_a_function, may_be_a_bool_with_t_behind_a_reference) {
  const auto f = [](F3 o, F3 d, F3 c, float r, float& t) { return (t = both(o, d, c, r).x) > 0; };
  EXPECT_EQ(answer_of(sphere_case("-5"), f), hit_at("2"));
  EXPECT_EQ(answer_of(sphere_case("5"), f), miss);
}

TEST(result_of_a_function, may_be_a_bool_alone) {
  const auto f = [](F3 o, F3 d, F3 c, float r) { return both(o, d, c, r).x > 0; };
  EXPECT_EQ(answer_of(sphere_case("-5"), f), "{\"id\": 7, \"verdict\": \"hit\"}\n");
  EXPECT_EQ(answer_of(sphere_case("-5", R"(, "t_max": 9)"), f), unsupported) << "it cannot know of t_max";
}

TEST(result_of_a_function, may_be_glsls_negative_number_for_a_miss) {
  const auto f = [](F3 o, F3 d, F3 c, float r) { return o.z > 0 ? -1.F : both(o, d, c, r).x; };
  EXPECT_EQ(answer_of(sphere_case("-5"), f), hit_at("2"));
  EXPECT_EQ(answer_of(sphere_case("5"), f), miss);
  EXPECT_EQ(answer_of(sphere_case("5", R"(, "t_min": -9)"), f), unsupported) << "-1 might be a hit there";
}

TEST(result_of_a_function, may_be_all_hits) {
  EXPECT_EQ(answer_of(sphere_case("-5"), both), hit_at("2", "3"));
  EXPECT_EQ(answer_of(sphere_case("0"), both), hit_at("0.5"));
  const auto list = [](F3 o, F3 d, F3 c, float r) {
    const vec2 t = both(o, d, c, r);
    return std::vector<float>{t.x, t.y};
  };
  EXPECT_EQ(answer_of(sphere_case("-5"), list), hit_at("2", "3"));
  EXPECT_EQ(answer_of(sphere_case("-5", R"(, "t_max": 2.5)"), list), hit_at("2"));
  const auto outputs = [](F3 o, F3 d, F3 c, float r, float& t0, float& t1) {
    t0 = both(o, d, c, r).x;
    t1 = both(o, d, c, r).y;
    return o.z < 9 ? 2 : 0;
  };
  EXPECT_EQ(answer_of(sphere_case("-5"), outputs), hit_at("2", "3"));
  EXPECT_EQ(answer_of(sphere_case("9"), outputs), miss);
}

TEST(result_of_a_function, may_be_t_with_u_and_v_behind_references) {
  const std::string triangle_line =
      R"({"id": 7, "precision": "float32", "ray": {"origin": [0.25,0.5,2], "direction": [0,0,-1]}, "shape": {"type": "triangle", "a": [0,0,0], "b": [1,0,0], "c": [0,1,0]}})";
  const auto f = [](F3 o, F3, F3, F3, F3, float& u, float& v) {
    u = o.x;
    v = o.y;
    return o.z;
  };
  EXPECT_EQ(
      answer_of(triangle_line, f),
      "{\"id\": 7, \"verdict\": \"hit\", \"hits\": [{\"t\": 2}], \"barycentric\": [0.25, 0.25, 0.5]}\n");
}

TEST(result_of_a_function, may_have_a_point_and_a_normal) {
  const std::string whole =
      R"({"id": 7, "verdict": "hit", "hits": [{"t": 2}], "point": [0, 0, -1], "normal": [0, 0, -1]})"
      "\n";
  const auto record = [](F3 o, F3 d, F3 c, float r) -> std::optional<Hit> {
    const float t = both(o, d, c, r).x;
    return Hit{t, o + t * d, o + t * d - c};
  };
  EXPECT_EQ(answer_of(sphere_case("-5"), record), whole);
  const auto outputs = [](F3 o, F3 d, F3 c, float r, float& t, F3& point, F3& normal) {
    t = both(o, d, c, r).x;
    normal = point = o + t * d;
    return true;
  };
  EXPECT_EQ(answer_of(sphere_case("-5"), outputs), whole);
  const auto glsl = [](F3 o, F3 d, F3 c, float r) { return vec4(both(o, d, c, r).x, 0, 0, -1); };
  EXPECT_EQ(answer_of(sphere_case("-5"), glsl),
            "{\"id\": 7, \"verdict\": \"hit\", \"hits\": [{\"t\": 2}], \"normal\": [0, 0, -1]}\n");
}

TEST(result_of_a_function, may_be_a_point_without_t) {
  const auto f = [](F3 o, F3 d, F3, float r, F3& point) {
    point = F3(0, 0, -r);
    return o.z * d.z < 0;
  };
  EXPECT_EQ(answer_of(sphere_case("-5"), f), "{\"id\": 7, \"verdict\": \"hit\", \"point\": [0, 0, -1]}\n");
  EXPECT_EQ(answer_of(sphere_case("5"), f), "{\"id\": 7, \"verdict\": \"miss\"}\n");
}

TEST(result_of_a_function, keeps_its_point_with_its_hit) {
  const auto all = [](F3, F3, F3, float, float& t0, float& t1, F3& point) {
    t0 = -0.5F;
    t1 = 0.5F;
    point = F3(0, 0, -1);
    return true;
  };
  EXPECT_EQ(answer_of(sphere_case("0"), all), hit_at("0.5"))
      << "the point is that of a hit that does not count";
}

TEST(result_of_a_function, that_is_nan_beside_a_hit_is_not_hidden) {
  const auto f = [](F3, F3, F3, float, float& t) {
    t = std::nanf("");
    return true;
  };
  EXPECT_EQ(answer_of(sphere_case("-5"), f), hit_at("\"nan\""));
}

TEST(result_of_a_function, that_is_infinite_beside_a_hit_is_not_hidden) {
  struct HitWithT {
    bool hit;
    float t;
  };
  const auto divides_by_0 = [](F3, F3, F3, float) -> HitWithT { return {true, infinity<float>}; };
  EXPECT_EQ(answer_of(sphere_case("-5"), divides_by_0), hit_at("\"inf\""));
  const auto all = [](F3, F3, F3, float) { return std::vector<float>{2, infinity<float>}; };
  EXPECT_EQ(answer_of(sphere_case("-5"), all), hit_at("2")) << "what is endlessly far is no hit of a list";
}

TEST(result_of_a_function, may_be_hit_and_a_point_without_t) {
  struct HitWithPoint {
    bool hit;
    F3 point;
  };
  const auto f = [](F3 o, F3, F3, float) -> HitWithPoint { return {o.z < 0, {0, 0, -1}}; };
  EXPECT_EQ(answer_of(sphere_case("-5"), f), "{\"id\": 7, \"verdict\": \"hit\", \"point\": [0, 0, -1]}\n");
  EXPECT_EQ(answer_of(sphere_case("5"), f), "{\"id\": 7, \"verdict\": \"miss\"}\n");
}

TEST(result_of_a_function, may_be_an_exception) {
  const auto gives_up = [](F3, F3, F3, float) -> bool { throw std::runtime_error("no \"idea\""); };
  EXPECT_EQ(answer_of(sphere_case("-5"), gives_up), "{\"id\": 7, \"error\": \"no \\\"idea\\\"\"}\n");
  const auto declines = [](F3, F3, F3, float) -> bool { throw Unsupported(); };
  EXPECT_EQ(answer_of(sphere_case("-5"), declines), unsupported);
}

}  // namespace
}  // namespace rayproof
