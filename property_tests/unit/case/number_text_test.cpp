#include "case/json/number_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <random>

namespace rayproof {
namespace {

std::string written(double x) {
  std::string out;
  append_number(out, x);
  return out;
}

std::string written(double x, Precision precision) {
  std::string out;
  append_number(out, x, precision);
  return out;
}

std::string written_hex(double x) {
  std::string out;
  append_hex(out, x);
  return out;
}

/// The bits, so that -0 differs from 0.
std::uint64_t bits_of(double x) { return std::bit_cast<std::uint64_t>(x); }

struct Spelling {
  std::string text;
  double value;
};

TEST(number_text, is_read_as_the_nearest_double) {
  const std::string zeros(2000, '0');
  for (const Spelling& spelling : {
           Spelling{"0", 0.0},
           {"-0", -0.0},
           {"-0.0", -0.0},
           {"0.1", 0.1},
           {"-12.5e3", -12500},
           {"1E2", 100},
           {"+1.5e+1", 15},
           {".5", 0.5},
           {"5.", 5},
           {"inf", infinity<double>},
           {"-inf", -infinity<double>},
           {"1e999", infinity<double>},
           {"-1e99999999999999999999", -infinity<double>},
           {"1e-999", 0},
           {"-1e-99999999999999999999", -0.0},
           {"0e99999999999999999999", 0},
           {"1.7976931348623158e308", std::numeric_limits<double>::max()},
           {"1.7976931348623159e308", infinity<double>},  // from halfway to 2^1024 on
           {"4.9e-324", 0x1p-1074},
           {"2.4703282292062328e-324", 0x1p-1074},  // above half the smallest subnormal
           {"2.4703282292062327e-324", 0},          // below it
           {"9007199254740993", 0x1p53},            // a tie, to even
           {"9007199254740993." + zeros + "1", 0x1.0000000000001p53},
           {"1" + zeros + "e-2000", 1},
           {"123456789012345678901234567890", 123456789012345678901234567890.0},  // beyond 64 bits
           {"0x1.8p+1", 3},
           {"-0X1.8P+1", -3},
           {"0x0p+0", 0},
           {"-0x0.0p+0", -0.0},
           {"0x1.8", 1.5},
           {"0x.8p0", 0.5},
           {"0x1p1024", infinity<double>},
           {"-0x1p99999999999999999999", -infinity<double>},
           {"0x1.fffffffffffff7p1023", std::numeric_limits<double>::max()},
           {"0x1.fffffffffffff8p1023", infinity<double>},
           {"0x1p-1074", 0x1p-1074},
           {"0x1p-1075", 0},  // a tie, to even
           {"0x1.0000000000001p-1075", 0x1p-1074},
           {"0x1.00000000000008p0", 1},  // a tie, to even
           {"0x1.00000000000008" + zeros + "1p0", 0x1.0000000000001p0},
           {"0x1.00000000000018p0", 0x1.0000000000002p0},
       }) {
    const auto read = parse_number(spelling.text);
    ASSERT_TRUE(read) << spelling.text;
    EXPECT_EQ(bits_of(*read), bits_of(spelling.value)) << spelling.text << " was read as " << *read;
  }
  EXPECT_TRUE(std::isnan(*parse_number("nan")));
}

TEST(number_text, of_any_other_spelling_is_refused) {
  for (const std::string text :
       {"",      " ",   "1 ",    " 1",      "\t1",     "1\n",   "abc",   "infinity", "Inf", "INF", "+inf",
        "-nan",  "NaN", "nan()", "1e",      "1e+",     "e5",    ".",     "-",        "+",   "--1", "+-1",
        "1.2.3", "1,5", "1_000", "0x",      "0x.p1",   "0x1p",  "0x1p+", "0x1.8pa",  "x1",  "0xg", "1f",
        "1.0L",  "0b1", "1e5.5", "0x1p1.5", "0x1p+-1", "1e+-1", "١",     "1e 5",     "0x 1"}) {
    EXPECT_FALSE(parse_number(text)) << '\'' << text << '\'';
  }
  EXPECT_FALSE(parse_number(std::string_view("1\0", 2)));
}

TEST(number_text, is_written_as_json_that_reads_back_bit_for_bit) {
  EXPECT_EQ(written(4), "4");
  EXPECT_EQ(written(-0.0), "-0.0");
  EXPECT_EQ(written(static_cast<double>(0.1F)), "0.10000000149011612");
  EXPECT_EQ(written(1e300), "1e+300");
  EXPECT_EQ(written(infinity<double>), "\"inf\"");
  EXPECT_EQ(written(-infinity<double>), "\"-inf\"");
  EXPECT_EQ(written(std::nan("")), "\"nan\"");
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto x = std::bit_cast<double>(random());
    if (!std::isfinite(x)) continue;
    EXPECT_EQ(bits_of(*parse_number(written(x))), bits_of(x)) << written(x);
    const std::string hex = written_hex(x);
    EXPECT_EQ(bits_of(*parse_number(std::string_view(hex).substr(1, hex.size() - 2))), bits_of(x)) << hex;
  }
}

TEST(number_text, of_a_float32_case_has_the_digits_that_a_float_needs) {
  EXPECT_EQ(written(static_cast<double>(0.1F), Precision::float32), "0.1");
  EXPECT_EQ(written(0.1, Precision::float64), "0.1");
  EXPECT_EQ(written(0.1, Precision::float32), "0.1") << "it is rounded to the precision when it is read";
  EXPECT_EQ(written(1e300, Precision::float32), "1e+300");
  std::mt19937 random(2);
  for (int i = 0; i < 20000; ++i) {
    const auto x = static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(random())));
    if (!std::isfinite(x)) continue;
    const std::string text = written(x, Precision::float32);
    EXPECT_EQ(bits_of(round_to(Precision::float32, *parse_number(text))), bits_of(x)) << text;
  }
}

TEST(number_text, in_hex_is_written_as_printf_does) {
  for (const double x : {0.0, -0.0, 1.0, -1.5, 6.0, 0.1, 0x1p-1074, 0x1.8p-1073, 0x1p-1022, 1e300}) {
    std::array<char, 64> expected{};
    std::snprintf(expected.data(), expected.size(), "\"%a\"", x);
    EXPECT_EQ(written_hex(x), expected.data());
  }
  EXPECT_EQ(written_hex(infinity<double>), "\"inf\"");
}

}  // namespace
}  // namespace rayproof
