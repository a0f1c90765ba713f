/// \file
/// Lines that are nearly cases: every line gets one line back, whatever is wrong with it, and nothing
/// crashes.
///
/// RAYPROOF_MUTATED_LINES=1000000 build/release/bin/unit-programs --gtest_filter='mutation.*' is the long
/// run.

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>

#include "case/reader.hpp"
#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "oracle/oracle.hpp"

namespace rayproof {
namespace {

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t limit) { return static_cast<std::size_t>(random() % limit); }

template <class Values>
const auto& pick(Random& random, const Values& values) {
  return values[below(random, std::size(values))];
}

/// The places where a number, a word, a list or an object begins.
std::vector<std::size_t> beginnings(const std::string& line) {
  std::vector<std::size_t> found;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (std::string_view("[{:, ").find(line[i - 1]) != std::string_view::npos) found.push_back(i);
  }
  return found;
}

void flip_bytes(Random& random, std::string& line) {
  for (std::size_t i = 0; i < 1 + below(random, 3); ++i) {
    char& byte = line[below(random, line.size())];
    byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << below(random, 8)));
    if (byte == '\n') byte = ' ';
  }
}

void drop_or_repeat_a_part(Random& random, std::string& line) {
  const std::size_t start = below(random, line.size());
  const std::string part = line.substr(start, 1 + below(random, 40));
  if (random() % 2 == 0) {
    line.erase(start, part.size());
  } else {
    line.insert(start, part);
  }
}

void put_in_a_value(Random& random, std::string& line) {
  static const std::string deep = std::string(2000, '[') + std::string(2000, ']');
  static const std::vector<std::string> values{"0",
                                               "-0",
                                               "1e999",
                                               "-1e999",
                                               "1e-999",
                                               "5e-324",
                                               "1.7976931348623157e308",
                                               "\"inf\"",
                                               "\"-inf\"",
                                               "\"nan\"",
                                               "null",
                                               "true",
                                               "{}",
                                               "[]",
                                               "\"\"",
                                               "\"0x\"",
                                               "\"0x1p-1074\"",
                                               "01",
                                               "\"\\ud800\"",
                                               "\"\xff\"",
                                               "\"sphere\"",
                                               "1e",
                                               "[[[]]]",
                                               "{\"a\": {}}",
                                               "\\",
                                               "\"quadratic\"",
                                               "12345678901234567890123",
                                               deep};
  const std::vector<std::size_t> places = beginnings(line);
  const std::size_t start = pick(random, places);
  const std::size_t end = line.find_first_of(",]}", start);
  line.replace(start, end == std::string::npos ? end : end - start, pick(random, values));
}

void rename_a_field(Random& random, std::string& line) {
  static const std::vector<std::string> names{"id",     "ray",    "shape",    "transform", "type",
                                              "radius", "center", "origin",   "t_min",     "query",
                                              "a",      "note",   "precision"};
  const std::size_t at = line.find('"' + pick(random, names) + '"');
  if (at != std::string::npos) line.replace(at + 1, line.find('"', at + 1) - at - 1, pick(random, names));
}

std::string mutated(Random& random) {
  const Family& family = pick(random, families());
  const Precision precision = random() % 2 == 0 ? Precision::float32 : Precision::float64;
  Case one = family.generate(random(), precision);
  one.id = std::to_string(random());
  if (random() % 3 == 0) one.note = "é\"\\\n";
  std::string line = write_case(one);
  for (std::size_t i = 0; i < 1 + below(random, 3) && line.size() > 2; ++i) {
    pick(random, std::array{flip_bytes, drop_or_repeat_a_part, put_in_a_value, rename_a_field})(random, line);
  }
  return line;
}

/// The one line that a line gets back.
std::string reply_to(const std::string& line, std::size_t number, std::size_t& refused) {
  try {
    const Case one = read_case(line);
    return write_answer(one, oracle::answer(one));
  } catch (const RefusedCase& why) {
    ++refused;
    return write_refusal(why, number);
  }
}

/// An id may be any JSON, 1e999 too, which this parser knows but refuses to hold.
bool is_json(const std::string& text) {
  try {
    return nlohmann::json::parse(text).is_object();
  } catch (const nlohmann::json::out_of_range&) {
    return true;
  } catch (const nlohmann::json::exception&) {
    return false;
  }
}

TEST(mutation, every_line_gets_one_valid_line_back) {
  const char* const wish = std::getenv("RAYPROOF_MUTATED_LINES");
  const std::size_t count = wish != nullptr ? std::strtoull(wish, nullptr, 10) : 20000;
  Random random(20260101);
  std::size_t refused = 0;
  for (std::size_t i = 1; i <= count; ++i) {
    const std::string line = mutated(random);
    const std::string reply = reply_to(line, i, refused);
    ASSERT_EQ(reply.find('\n'), std::string::npos) << line;
    ASSERT_TRUE(is_json(reply)) << line << '\n' << reply;
  }
  EXPECT_GT(refused, count / 3) << "the mutations must do harm";
  EXPECT_LT(refused, count - count / 50) << "and leave some lines valid";
}

}  // namespace
}  // namespace rayproof
