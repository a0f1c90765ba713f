#include "case/reader/shape_reader.hpp"

#include <gtest/gtest.h>

#include "case/json/writer.hpp"

namespace rayproof {
namespace {

// Made-up shapes with every type of field. Nothing but their ShapeFormat informs the reader and the writer of
// them.
struct Prism {
  std::vector<glm::dvec3> base;
  std::array<glm::dvec3, 2> ends;
  double height = 0;
  bool capped = false;
};
struct PointAndNormal {
  glm::dvec3 point, normal;
};
struct NormalForm {
  glm::dvec3 normal;
  double d = 0;
};

}  // namespace

template <>
struct ShapeFormat<Prism> {
  static constexpr const char* type = "prism";
  template <class S, class Visit>
  static void fields(S& prism, Visit&& visit) {
    visit("base", prism.base);
    visit("ends", prism.ends);
    visit("height", prism.height);
    visit("capped", prism.capped);
  }
  static void validate(const Prism& prism) {
    if (prism.base.size() < 3) throw Refusal("base", "the prism's base must have three corners");
  }
};
template <>
struct ShapeFormat<NormalForm> {
  static constexpr const char* type = "sheet";
  template <class S, class Visit>
  static void fields(S& sheet, Visit&& visit) {
    visit("normal", sheet.normal);
    visit("d", sheet.d);
  }
  static void validate(const NormalForm& /*sheet*/) {}
};
template <>
struct ShapeFormat<PointAndNormal> {
  static constexpr const char* type = "sheet";
  template <class S, class Visit>
  static void fields(S& sheet, Visit&& visit) {
    visit("point", sheet.point);
    visit("normal", sheet.normal);
  }
  static void validate(const PointAndNormal& /*sheet*/) {}
};

namespace {

using MadeUp = std::variant<Prism, NormalForm, PointAndNormal>;

MadeUp read(std::string_view text) {
  const json::Document document = json::parse(text);
  const Field field{.document = &document};
  MadeUp shape;
  read_shape(field, Precision::float32, shape);
  return shape;
}

std::string why_refused(std::string_view text) {
  try {
    static_cast<void>(read(text));
    return "not refused";
  } catch (const Refusal& why) {
    return why.what();
  }
}

TEST(shape_reader, reads_a_new_shape_by_its_format_alone) {
  const MadeUp shape = read(
      R"({"height": 0.1, "type": "prism", "base": [[0,0,0],[1,0,0],[0,1,0]], "ends": [[1,2,3],[4,5,6]], "capped": true})");
  const auto& prism = std::get<Prism>(shape);
  EXPECT_EQ(prism.base.size(), 3U);
  EXPECT_EQ(prism.ends[1], glm::dvec3(4, 5, 6));
  EXPECT_EQ(prism.height, static_cast<double>(0.1F));
  EXPECT_TRUE(prism.capped);
}

TEST(shape_reader, lets_a_switch_be_left_out) {
  const auto shape =
      read(R"({"type": "prism", "base": [[0,0,0],[1,0,0],[0,1,0]], "ends": [[1,2,3],[4,5,6]], "height": 1})");
  EXPECT_FALSE(std::get<Prism>(shape).capped);
}

TEST(shape_reader, distinguishes_the_forms_of_a_type_by_their_fields) {
  EXPECT_TRUE(std::holds_alternative<NormalForm>(read(R"({"type": "sheet", "normal": [0,0,1], "d": 2})")));
  EXPECT_TRUE(std::holds_alternative<PointAndNormal>(
      read(R"({"type": "sheet", "normal": [0,0,1], "point": [1,2,3]})")));
}

TEST(shape_reader, names_the_field_that_is_wrong_however_deep_it_lies) {
  EXPECT_EQ(why_refused(R"({"type": "prism", "base": [[0,0,0],[1,0]], "ends": [], "height": 1})"),
            "base[1] must be an array of 3 numbers");
  EXPECT_EQ(
      why_refused(R"({"type": "prism", "base": [[0,0,0],[1,0,"x"]], "ends": [], "height": 1})").substr(0, 10),
      "base[1][2]");
  EXPECT_EQ(why_refused(R"({"type": "prism", "base": 5})"), "base must be an array");
  EXPECT_EQ(why_refused(R"({"type": "prism", "base": [], "ends": [[1,2,3]], "height": 1})"),
            "ends must be an array of 2");
  EXPECT_EQ(
      why_refused(R"({"type": "prism", "base": [], "ends": [[1,2,3],[4,5,6]], "height": 1, "capped": 1})"),
      "capped must be true or false");
  EXPECT_EQ(why_refused(R"({"type": "prism", "base": [], "ends": [[1,2,3],[4,5,6]], "height": 1})"),
            "the prism's base must have three corners");
}

TEST(shape_reader, knows_the_types_from_the_list_of_shapes) {
  EXPECT_EQ(why_refused(R"({"type": "blob"})"),
            R"(type is an unknown shape type, "blob"; known: "prism", "sheet")");
}

TEST(json_writer, writes_a_new_shape_by_its_format_alone) {
  const Prism prism{{{1, 2, 3}}, {glm::dvec3(0), glm::dvec3(1)}, static_cast<double>(0.1F), true};
  JsonWriter json;
  ShapeFormat<Prism>::fields(prism, [&](const char* name, const auto& value) {
    json.member(name).value(value, Precision::float32);
  });
  EXPECT_EQ(json.take(),
            R"({"base": [[1, 2, 3]], "ends": [[0, 0, 0], [1, 1, 1]], "height": 0.1, "capped": true})");
}

}  // namespace
}  // namespace rayproof
