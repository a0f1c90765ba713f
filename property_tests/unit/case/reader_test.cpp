#include "case/reader.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "far_sphere.hpp"

namespace rayproof {
namespace {

const RayQuestion& ray_question(const Case& one) { return std::get<RayQuestion>(one.question); }

TEST(reader, reads_every_field_and_rounds_it_to_the_precision) {
  const Case one = read_case(far_sphere);
  EXPECT_EQ(one.id, "7");
  EXPECT_EQ(one.precision, Precision::float32);
  EXPECT_EQ(one.note, "café");
  const RayQuestion& question = ray_question(one);
  EXPECT_EQ(question.ray.origin, glm::dvec3(0, 0, -5));
  EXPECT_EQ(question.ray.direction, glm::dvec3(0, 0, 1));
  EXPECT_EQ(question.ray.t_min, static_cast<double>(0.1F));
  EXPECT_EQ(question.ray.t_max, infinity<double>);
  const auto& sphere = std::get<Sphere<double>>(question.shape);
  EXPECT_EQ(sphere.center, glm::dvec3(static_cast<double>(0.1F), 2, 3));
  EXPECT_EQ(sphere.radius, 1);
  EXPECT_EQ((*question.transform)[0], glm::dvec4(2, 0, 0, 0)) << "GLM keeps columns";
  EXPECT_EQ((*question.transform)[3], glm::dvec4(7, 8, 9, 1));
  EXPECT_EQ(topic_of(one), "sphere");
}

TEST(reader, takes_the_defaults_of_what_is_left_out) {
  const Case one = read_case(
      R"({"ray": {"origin": [0,0,0], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 0}})");
  EXPECT_EQ(one.id, "");
  EXPECT_EQ(one.precision, Precision::float64);
  EXPECT_EQ(one.note, "");
  EXPECT_EQ(ray_question(one).ray.t_min, 0);
  EXPECT_EQ(ray_question(one).ray.t_max, infinity<double>);
  EXPECT_FALSE(ray_question(one).transform);
}

TEST(reader, reads_a_quadratic) {
  const Case one = read_case(R"({"query": "quadratic", "a": 0.1, "b": -3, "c": 2, "precision": "float32"})");
  EXPECT_EQ(topic_of(one), "quadratic");
  EXPECT_EQ(std::get<Quadratic<double>>(one.question).a, static_cast<double>(0.1F));
}

TEST(reader, keeps_the_id_as_it_was_given) {
  for (const std::string_view id : {"7", "-0", "1.50", "1e999", "12345678901234567890123", "null", "true",
                                    R"("caf\u00e9 é")", R"([1, {"x":  2}])"}) {
    EXPECT_EQ(read_case(replaced(far_sphere, "7", id)).id, id);
    try {
      static_cast<void>(read_case(replaced(replaced(far_sphere, "7", id), "0.1", "nan")));
    } catch (const RefusedCase& why) {
      EXPECT_EQ(why.id(), "") << "a line that is not JSON has no id";
    }
    try {
      static_cast<void>(read_case(replaced(replaced(far_sphere, "7", id), "0.1", "\"nan\"")));
    } catch (const RefusedCase& why) {
      EXPECT_EQ(why.id(), id);
    }
  }
}

TEST(reader, takes_the_last_of_two_fields_of_one_name) {
  EXPECT_EQ(std::get<Sphere<double>>(ray_question(read_case(replaced(far_sphere, "\"radius\": 1",
                                                                     R"("radius": "x", "r\u0061dius": 2)")))
                                         .shape)
                .radius,
            2);
}

TEST(reader, judges_numbers_after_rounding_them) {
  // To a float these are 0, the two ends of the interval are equal, and the transform is the identity.
  EXPECT_EQ(std::get<Sphere<double>>(
                ray_question(read_case(replaced(far_sphere, "\"radius\": 1", "\"radius\": -1e-50"))).shape)
                .radius,
            0);
  EXPECT_NO_THROW(static_cast<void>(read_case(replaced(far_sphere, "\"inf\"", "0.09999999999"))));
  EXPECT_NO_THROW(
      static_cast<void>(read_case(replaced(far_sphere, "[0,0,0,1]", "[0,0,1e-60,1.00000000001]"))));
  EXPECT_EQ(ray_question(read_case(replaced(far_sphere, "\"inf\"", "1e39"))).ray.t_max, infinity<double>);
  EXPECT_EQ(ray_question(read_case(replaced(far_sphere, "\"inf\"", "1e999"))).ray.t_max, infinity<double>);
  EXPECT_EQ(ray_question(read_case(replaced(far_sphere, "0.1", "-1e999"))).ray.t_min, -infinity<double>);
}

}  // namespace
}  // namespace rayproof
