#include "case/writer.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "generators/generators.hpp"

namespace rayproof {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Case with_id(std::string id) {
  Case one;
  one.id = std::move(id);
  return one;
}

TEST(writer, writes_an_answer_as_the_format_has_it) {
  RayAnswer answer{
      .contact = Contact::crossing, .point = glm::dvec3(0, 0, -1), .normal = glm::dvec3(0, -0.0, -1)};
  answer.hits.push_back(4);
  answer.hits.push_back(6);
  EXPECT_EQ(write_answer(with_id("7"), answer),
            R"({"id": 7, "verdict": "hit", "contact": "crossing", )"
            R"("hits": [{"t": 4, "t_hex": "0x1p+2"}, {"t": 6, "t_hex": "0x1.8p+2"}], )"
            R"("point": [0, 0, -1], "normal": [0, -0.0, -1]})");
}

TEST(writer, leaves_out_what_an_answer_has_not) {
  EXPECT_EQ(write_answer(with_id(""), RayAnswer{}), R"({"verdict": "miss", "contact": "none", "hits": []})");
}

TEST(writer, writes_infinities_as_strings) {
  RayAnswer answer{.contact = Contact::tangent, .point = glm::dvec3(-infinity<double>, 0, infinity<double>)};
  answer.hits.push_back(infinity<double>);
  EXPECT_EQ(write_answer(with_id("[1]"), answer),
            R"({"id": [1], "verdict": "hit", "contact": "tangent", "hits": [{"t": "inf", "t_hex": "inf"}], )"
            R"("point": ["-inf", 0, "inf"]})");
}

TEST(writer, names_every_kind_of_roots) {
  const auto written = [](const QuadraticAnswer<double>& answer) {
    return write_answer(with_id(""), answer);
  };
  EXPECT_EQ(written({RootKind::two, 2, {1, 2}}),
            R"({"kind": "two", "roots": [{"x": 1, "x_hex": "0x1p+0"}, {"x": 2, "x_hex": "0x1p+1"}]})");
  EXPECT_EQ(written({RootKind::twice, 1, {0.5}}),
            R"({"kind": "double", "roots": [{"x": 0.5, "x_hex": "0x1p-1"}]})");
  EXPECT_EQ(written({RootKind::linear, 1, {-0.0}}),
            R"({"kind": "linear", "roots": [{"x": -0.0, "x_hex": "-0x0p+0"}]})");
  EXPECT_EQ(written({RootKind::none}), R"({"kind": "none", "roots": []})");
  EXPECT_EQ(written({RootKind::constant}), R"({"kind": "constant", "roots": []})");
  EXPECT_EQ(written({RootKind::everything}), R"({"kind": "everything", "roots": []})");
}

TEST(writer, writes_a_refusal_that_is_always_json) {
  EXPECT_EQ(write_refusal(RefusedCase(Refusal("a", "a is \"odd\""), "\"x\""), 12),
            R"({"id": "x", "line": 12, "error": "a is \"odd\""})");
  EXPECT_EQ(write_refusal(RefusedCase(Refusal("a", "a is missing"), ""), 1),
            R"({"id": null, "line": 1, "error": "a is missing"})");
}

TEST(writer, writes_a_case_with_the_fewest_digits_that_read_back) {
  Case one{"1", Precision::float32, "a \"note\"", {}};
  RayQuestion question{
      {{0, 0, -5}, {static_cast<double>(0.1F), 0, 1}}, Sphere<double>{{1, 2, 3}, 1}, glm::dmat4(2)};
  (*question.transform)[3] = {7, 8, 9, 1};
  one.question = question;
  EXPECT_EQ(
      write_case(one),
      R"({"id": 1, "precision": "float32", "ray": {"origin": [0, 0, -5], "direction": [0.1, 0, 1], )"
      R"("t_min": 0, "t_max": "inf"}, "shape": {"type": "sphere", "center": [1, 2, 3], "radius": 1}, )"
      R"("transform": [[2, 0, 0, 7], [0, 2, 0, 8], [0, 0, 2, 9], [0, 0, 0, 1]], "note": "a \"note\""})");
  EXPECT_EQ(write_case({"", Precision::float64, "", Quadratic<double>{1, nan, -infinity<double>}}),
            R"({"precision": "float64", "query": "quadratic", "a": 1, "b": "nan", "c": "-inf"})");
}

TEST(writer, writes_cases_that_read_back_bit_for_bit) {
  for (const Family& family : families()) {
    // Few of each, for id and note: generators/ reads back hundreds of cases of each family.
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      Case one = family.generate(seed, seed % 2 == 0 ? Precision::float32 : Precision::float64);
      one.id = std::to_string(seed);
      one.note = family.description;
      const std::string line = write_case(one);
      EXPECT_TRUE(nlohmann::json::accept(line)) << line;
      try {
        EXPECT_EQ(write_case(read_case(line)), line);
      } catch (const RefusedCase& why) {
        ADD_FAILURE() << family.topic << '/' << family.name << ": " << why.what() << '\n' << line;
        break;
      }
    }
  }
}

}  // namespace
}  // namespace rayproof
