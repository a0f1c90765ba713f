#include "refused.hpp"
#include "unit/shape_types.hpp"

namespace rayproof {
namespace {

/// "sphere", "plane" and so on, in quotes.
std::string known_types() {
  std::string list;
  for (const std::string& type : ray_topics()) list += (list.empty() ? "\"" : ", \"") + type + "\"";
  return list;
}

TEST(reader, refuses_what_is_not_an_object) {
  expect_refused("", "line", "the line is not JSON: expected a value at byte 1");
  expect_refused("\xEF\xBB\xBF{}", "line", "the line is not JSON: expected no byte order mark at byte 1");
  expect_refused("[1]", "", "the case must be a JSON object");
  expect_refused("7", "", "the case must be a JSON object");
}

TEST(reader, refuses_missing_and_unknown_fields) {
  expect_refused({
      {"\"ray\"", "\"light\"", "ray", "ray is missing"},
      {"\"origin\"", "\"o\"", "ray.origin", "ray.origin is missing"},
      {"\"type\"", "\"kind\"", "shape.type", "shape.type is missing"},
      {"\"radius\"", "\"r\"", "shape.radius", "shape.radius is missing"},
      {"\"note\"", "\"comment\"", "", "the case has an unknown field \"comment\""},
      {"\"radius\": 1", "\"radius\": 1, \"color\": 3", "shape", "shape has an unknown field \"color\""},
      {"\"radius\": 1", "\"radius\": 1, \"centre\": 3", "shape", "shape has an unknown field \"centre\""},
  });
  expect_refused(R"({"query": "quadratic", "a": 1, "b": 2})", "c", "c is missing");
  expect_refused(R"({"query": "quadratic", "a": 1, "b": 2, "c": 3, "ray": 4})", "",
                 "the case has an unknown field \"ray\"");
}

TEST(reader, refuses_values_of_the_wrong_kind) {
  const std::string number =
      R"( must be a number, or a string like "0x1.8p+1", "1.5", "inf", "-inf" or "nan")";
  expect_refused({
      {"\"float32\"", "\"float\"", "precision",
       R"(precision is an unknown precision, "float"; known: "float32", "float64")"},
      {"\"float32\"", "\"flaot32\"", "precision",
       R"(precision is an unknown precision, "flaot32"; did you mean "float32"?)"},
      {"\"float32\"", "32", "precision", "precision must be a string"},
      {"[0,0,-5]", "5", "ray.origin", "ray.origin must be an array of 3 numbers"},
      {"[0,0,-5]", "[0,0]", "ray.origin", "ray.origin must be an array of 3 numbers"},
      {"[0,0,-5]", "[0,0,1,0]", "ray.origin", "ray.origin must be an array of 3 numbers"},
      {"-5", "true", "ray.origin[2]", "ray.origin[2]" + number},
      {"\"2\"", "\" 2\"", "shape.center[1]", "shape.center[1]" + number},
      {"\"2\"", "[2]", "shape.center[1]", "shape.center[1]" + number},
      {"\"2\"", "\"\"", "shape.center[1]", "shape.center[1]" + number},
      {"\"2\"", "\"infinite\"", "shape.center[1]", "shape.center[1]" + number},
      {"\"sphere\"", "\"triangel\"", "shape.type",
       R"(shape.type is an unknown shape type, "triangel"; did you mean "triangle"?)"},
      {"\"sphere\"", "\"torus\"", "shape.type",
       R"(shape.type is an unknown shape type, "torus"; known: )" + known_types()},
      {"\"sphere\"", "null", "shape.type", "shape.type must be a string"},
      {"\"caf\\u00e9\"", "5", "note", "note must be a string"},
  });
  expect_refused(R"({"ray": 1})", "ray", "ray must be a JSON object");
  expect_refused(R"({"query": "Quadratic"})", "query",
                 R"(query is an unknown query, "Quadratic"; did you mean "quadratic"?)");
  expect_refused(R"({"query": "cubic"})", "query",
                 R"(query is an unknown query, "cubic"; known: "quadratic", "point_in_polygon")");
  expect_refused(R"({"query": 1})", "query", "query must be a string");
}

TEST(reader, refuses_numbers_that_are_not_finite) {
  expect_refused({
      {"-5", "1e999", "ray.origin[2]", "ray.origin[2] must be finite as a float32"},
      {"-5", "3.5e38", "ray.origin[2]", "ray.origin[2] must be finite as a float32"},
      {"0x1p+0", "inf", "ray.direction[2]", "ray.direction[2] must be finite as a float32"},
      {"\"2\"", "\"nan\"", "shape.center[1]", "shape.center[1] must be finite as a float32"},
      {"\"radius\": 1", "\"radius\": \"inf\"", "shape.radius", "shape.radius must be finite as a float32"},
      {"[2,0,0,7]", "[2,0,0,\"-inf\"]", "transform[0][3]", "transform[0][3] must be finite as a float32"},
      {"0.1", "\"nan\"", "ray.t_min", "ray.t_min must be finite or -inf"},
      {"0.1", "\"inf\"", "ray.t_min", "ray.t_min must be finite or -inf"},
      {"\"inf\"", "\"-inf\"", "ray.t_max", "ray.t_max must be finite or inf"},
      {"\"inf\"", "\"nan\"", "ray.t_max", "ray.t_max must be finite or inf"},
  });
  expect_refused(R"({"query": "quadratic", "a": 1e400, "b": 2, "c": 3})", "a",
                 "a must be finite as a float64");
}

TEST(reader, refuses_rays_and_shapes_that_make_no_sense) {
  expect_refused({
      {"0x1p+0", "0x1p-200", "ray.direction", "ray.direction must not be zero"},
      {"0x1p+0", "-0", "ray.direction", "ray.direction must not be zero"},
      {"\"inf\"", "0.09", "ray.t_min", "ray.t_min must not be greater than ray.t_max"},
      {"\"radius\": 1", "\"radius\": -1", "radius", "the sphere's radius must not be negative"},
      {"\"radius\": 1", "\"radius\": -1e-45", "radius", "the sphere's radius must not be negative"},
  });
}

TEST(reader, refuses_a_transform_that_is_not_affine_or_is_singular) {
  expect_refused({
      {"[[2,0,0,7],", "[", "transform", "transform must be an array of 4 rows of 4 numbers"},
      {"[2,0,0,7]", "[2,0,0]", "transform[0]", "transform[0] must be an array of 4 numbers"},
      {"[0,0,0,1]", "[0,0,0,2]", "transform", "transform must be affine, with the last row 0 0 0 1"},
      {"[0,0,0,1]", "[0,1e-40,0,1]", "transform", "transform must be affine, with the last row 0 0 0 1"},
      {"[2,0,0,7]", "[0,0,0,7]", "transform", "transform must not be singular"},
      {"[2,0,0,7]", "[0,3,0,7]", "transform", "transform must not be singular"},
      {"[2,0,0,7]", "[1e-60,3,0,7]", "transform", "transform must not be singular"},
  });
  EXPECT_NO_THROW(static_cast<void>(read_case(replaced(far_sphere, "[2,0,0,7]", "[1e-44,3,0,7]"))));
}

}  // namespace
}  // namespace rayproof
