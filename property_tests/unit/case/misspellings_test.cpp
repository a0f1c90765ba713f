#include <algorithm>
#include <map>

#include "case/reader/near_names.hpp"
#include "refused.hpp"

namespace rayproof {
namespace {

TEST(reader, names_the_field_that_a_misspelt_one_stands_for) {
  expect_refused({
      {"\"ray\"", "\"rays\"", "", R"(the case has an unknown field "rays"; did you mean "ray"?)"},
      {"\"origin\"", "\"orgin\"", "ray", R"(ray has an unknown field "orgin"; did you mean "origin"?)"},
      {"\"direction\"", "\"dir\"", "ray", R"(ray has an unknown field "dir"; did you mean "direction"?)"},
      {"\"t_max\"", "\"tMax\"", "ray", R"(ray has an unknown field "tMax"; did you mean "t_max"?)"},
      {"\"shape\"", "\"shap\"", "", R"(the case has an unknown field "shap"; did you mean "shape"?)"},
      {"\"center\"", "\"centre\"", "shape", R"(shape has an unknown field "centre"; did you mean "center"?)"},
      {"\"radius\"", "\"Radius\"", "shape", R"(shape has an unknown field "Radius"; did you mean "radius"?)"},
      {"\"note\"", "\"Note\"", "", R"(the case has an unknown field "Note"; did you mean "note"?)"},
      {"\"transform\"", "\"trans\\u0066orn\"", "",
       R"(the case has an unknown field "trans\u0066orn"; did you mean "transform"?)"},
  });
  expect_refused(R"({"qery": "quadratic", "a": 1, "b": 2, "c": 3})", "",
                 R"(the case has an unknown field "qery"; did you mean "query"?)");
  const auto plane = [](std::string_view fields) {
    return replaced(far_sphere, R"("type": "sphere", "center": [0.1,"2",3e0], "radius": 1)", fields);
  };
  expect_refused(plane(R"("type": "plane", "normal": [0,0,1], "pont": [0,0,0])"), "shape",
                 R"(shape has an unknown field "pont"; did you mean "point"?)");
  // Of forms that lack as many fields, the one that has more of those that are there.
  expect_refused(plane(R"("type": "plane", "u": [0,0,1])"), "shape.point", "shape.point is missing");
  expect_refused(plane(R"("type": "plane")"), "shape.normal", "shape.normal is missing");
  expect_refused(plane(R"("type": "plane", "normal": [0,0,1], "D": 1)"), "shape",
                 R"(shape has an unknown field "D"; did you mean "d"?)");
}

/// While a field is missing, those that the reader has not asked for yet look unknown to it.
TEST(reader, takes_no_field_for_the_misspelling_of_another) {
  std::map<std::string, std::vector<std::string>> objects{
      {"ray question", {"id", "precision", "note", "query", "ray", "shape", "transform"}},
      {"quadratic", {"id", "precision", "note", "query", "a", "b", "c"}},
      {"point in polygon", {"id", "precision", "note", "query", "point", "vertices"}},
      {"ray", {"origin", "direction", "t_min", "t_max"}},
      {"scene", {"size", "camera", "shapes", "precision", "note"}},
      {"scene's entry", {"mesh", "shape", "transform"}},
      {"camera", {"eye", "center", "up", "fov_x", "fov_y"}}};
  const auto add = [&objects]<class S>(std::type_identity<S>) {
    std::vector<std::string>& names = objects[ShapeFormat<S>::type];
    S shape{};
    ShapeFormat<S>::fields(shape, [&names](const char* name, auto&) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
    });
  };
  [add]<class... S>(std::type_identity<std::variant<S...>>) {
    (add(std::type_identity<S>{}), ...);
  }(std::type_identity<Shape>{});
  EXPECT_EQ(objects["plane"].size(), 5U) << "normal, d, point, u, v";
  for (const auto& [object, names] : objects) {
    for (const std::string& one : names) {
      std::vector<std::string> others = names;
      std::erase(others, one);
      others.emplace_back("type");
      EXPECT_FALSE(likely_name(one, others)) << object << ": " << one;
    }
  }
}

TEST(reader, says_how_an_infinity_is_written) {
  const std::string not_json = "the line is not JSON: ";
  expect_refused({
      {"\"inf\"", "Infinity", "ray.t_max",
       not_json + "ray.t_max is Infinity, which is written \"inf\", a string"},
      {"0.1", "-Infinity", "ray.t_min",
       not_json + "ray.t_min is -Infinity, which is written \"-inf\", a string"},
      {"-5", "NaN", "ray.origin[2]", not_json + "ray.origin[2] is NaN, which no number of a case may be"},
      {"[0,1,0,8]", "[0,1,0,-nan]", "transform[1][3]",
       not_json + "transform[1][3] is -nan, which no number of a case may be"},
      {"\"inf\"", "Infinite", "line", not_json + "expected a value at byte 115"},
      {"\"inf\"", "1Infinity", "line", not_json + "expected ',' or '}' at byte 116"},
  });
  const std::string number =
      R"(ray.t_max must be a number, or a string like "0x1.8p+1", "1.5", "inf", "-inf" or "nan"; did you mean )";
  expect_refused({
      {"\"inf\"", "\"+inf\"", "ray.t_max", number + "\"inf\"?"},
      {"\"inf\"", "\"Infinity\"", "ray.t_max", number + "\"inf\"?"},
      {"\"inf\"", "\"-INFINITY\"", "ray.t_max", number + "\"-inf\"?"},
      {"\"inf\"", "\"NaN\"", "ray.t_max", number + "\"nan\"?"},
  });
}

}  // namespace
}  // namespace rayproof
