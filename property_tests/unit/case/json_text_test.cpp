#include "case/json/text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "case/shape_format.hpp"

namespace rayproof::json {
namespace {

bool is_accepted(std::string_view text) {
  try {
    static_cast<void>(parse(text));
    return true;
  } catch (const Refusal&) {
    return false;
  }
}

bool has_number_out_of_range(const std::string& text) {
  try {
    return nlohmann::json::parse(text).is_discarded();
  } catch (const nlohmann::json::out_of_range&) {
    return true;
  } catch (const nlohmann::json::exception&) {
    return false;
  }
}

TEST(json_text, keeps_every_value_as_it_was_written) {
  const Document document = parse(R"( {"a": [1.50, {"b": null}], "\u0063": "x\n"} )");
  ASSERT_EQ(document.size(), 6U);
  EXPECT_EQ(document[0].kind, Kind::object);
  EXPECT_EQ(document[0].end, 6U);
  EXPECT_EQ(document[1].key, R"("a")");
  EXPECT_EQ(document[1].text, R"([1.50, {"b": null}])");
  EXPECT_EQ(document[1].end, 5U);
  EXPECT_EQ(document[2].text, "1.50");
  EXPECT_EQ(document[4].key, R"("b")");
  EXPECT_EQ(unquote(document[5].key), "c");
  EXPECT_EQ(unquote(document[5].text), "x\n");
  EXPECT_EQ(unquote(R"("\/\b\u00e9\u20ac\ud83d\ude00 é")"), "/\bé€😀 é");
}

TEST(json_text, accepts_what_the_grammar_has) {
  for (const std::string_view text :
       {"0", "-0", "1e999", "1E+5", "0.5e-5", "[]", "{}", "[[],{}]", "\t\r\n null \n", "true",
        "\"\\ud83d\\ude00\"", R"("\"\\\/\b\f\n\r\t\u00e9")", "\"\x7f é 😀 \xf4\x8f\xbf\xbf\"",
        R"({"a":1,"a":2})"}) {
    EXPECT_TRUE(is_accepted(text)) << text;
  }
}

TEST(json_text, refuses_what_the_grammar_does_not_have) {
  for (const std::string_view text : {"",
                                      " ",
                                      "01",
                                      "+1",
                                      ".5",
                                      "5.",
                                      "1e",
                                      "1e+",
                                      "-",
                                      "--1",
                                      "0x1",
                                      "NaN",
                                      "Infinity",
                                      "nul",
                                      "nulll",
                                      "True",
                                      "[1,]",
                                      "[,1]",
                                      "[1 2]",
                                      "[1",
                                      "]",
                                      "{\"a\"}",
                                      "{\"a\":}",
                                      "{a:1}",
                                      "{'a':1}",
                                      "{\"a\":1,}",
                                      "{\"a\" 1}",
                                      "{1:2}",
                                      "[}",
                                      "{]",
                                      "1 2",
                                      "{}{}",
                                      "\"",
                                      "\"a",
                                      "\"\\\"",
                                      "\"\\x\"",
                                      "\"\\u12\"",
                                      "\"\\u12g4\"",
                                      "\"\\ud800\"",
                                      "\"\\ud800\\u0041\"",
                                      "\"\\udc00\"",
                                      "\"\t\"",
                                      "\"\x1f\"",
                                      "// x\n1",
                                      "\xef\xbb\xbf{}",
                                      "\"\xff\"",
                                      "\"\x80\"",
                                      "\"\xc0\x80\"",
                                      "\"\xe0\x80\x80\"",
                                      "\"\xed\xa0\x80\"",
                                      "\"\xf4\x90\x80\x80\"",
                                      "\"\xe2\x82\"",
                                      "\"\xf0\x9f\x98\""}) {
    EXPECT_FALSE(is_accepted(text)) << text;
  }
  EXPECT_FALSE(is_accepted(std::string_view("1\0", 2)));
  EXPECT_FALSE(is_accepted(std::string_view("\"\0\"", 3)));
}

TEST(json_text, says_where_it_stops_being_json) {
  try {
    static_cast<void>(parse(R"({"a": 1, b})"));
    FAIL();
  } catch (const Refusal& refusal) {
    EXPECT_STREQ(refusal.what(), "the line is not JSON: expected a field's name in quotes at byte 10");
  }
}

TEST(json_text, is_nested_as_deep_as_it_likes) {
  constexpr std::size_t depth = 1000000;
  EXPECT_FALSE(is_accepted(std::string(depth, '[')));
  EXPECT_TRUE(is_accepted(std::string(depth, '[') + std::string(depth, ']')));
  std::string objects;
  for (std::size_t i = 0; i < depth; ++i) objects += "{\"a\":";
  EXPECT_FALSE(is_accepted(objects));
  EXPECT_TRUE(is_accepted(objects + "1" + std::string(depth, '}')));
}

TEST(json_text, in_quotes_comes_back_as_it_went_in) {
  const std::string all = std::string("\"\\/\b\f\n\r\t\x01\x1f", 10) + '\0' + "é😀";
  EXPECT_EQ(unquote(quote(all)), all);
  EXPECT_EQ(nlohmann::json::parse(quote(all)), all);
}

/// The reference is a well-kept parser that differs in one thing only: it refuses numbers beyond a double's
/// range.
TEST(json_text, is_accepted_just_where_another_parser_accepts_it) {
  constexpr std::string_view seed =
      R"({"id": [1.5e3, -0], "a\u00e9": {"b": [true, null, "\ud83d\ude00é"]}, "": false})";
  constexpr std::string_view letters = "{}[]\",:\\ \t0123456789+-.eEtrufalsn\xc3\xa9\xed\xa0\x80\xff";
  std::mt19937 random(3);
  int accepted = 0;
  for (int i = 0; i < 50000; ++i) {
    std::string text(seed);
    for (std::size_t change = 0; change < 1 + random() % 3; ++change) {
      text[random() % text.size()] = letters[random() % letters.size()];
      const std::size_t length = random() % 3;
      if (random() % 2 == 0) text.erase(random() % text.size(), length);
    }
    const bool expected = nlohmann::json::accept(text);
    if (!expected && text.find_first_of("eE") != std::string::npos && is_accepted(text)) {
      EXPECT_TRUE(has_number_out_of_range(text)) << text;
      continue;
    }
    EXPECT_EQ(is_accepted(text), expected) << text;
    accepted += expected ? 1 : 0;
  }
  EXPECT_GT(accepted, 1000) << "too few of the changed texts are still JSON";
}

}  // namespace
}  // namespace rayproof::json
